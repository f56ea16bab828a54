Rect extent(const dmat4& M, const Cam& c) {
    const double s = c.h / (2 * std::tan(c.fovy / 2));
    Rect rect{INF, INF, -INF, -INF};
    for (const double side : {-1.0, 1.0}) {
        const dvec3 p(c.view * M * dvec4(side, side, side, 1));
        if (p.z > -c.n) continue;
        const double x = c.w / 2.0 + s * p.x / -p.z, y = c.h / 2.0 + s * p.y / -p.z;
        rect = {std::min(rect.x0, x), std::min(rect.y0, y), std::max(rect.x1, x), std::max(rect.y1, y)};
    }
    rect = {std::max(rect.x0, 0.0), std::max(rect.y0, 0.0), std::min(rect.x1, double(c.w)),
            std::min(rect.y1, double(c.h))};
    return rect.x0 < rect.x1 && rect.y0 < rect.y1 ? rect : Rect{};
}
