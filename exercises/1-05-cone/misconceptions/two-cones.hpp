Spans cone(const Ray& r) {
    const dvec2 o(r.o), d(r.d);
    const double w = 1 - r.o.z;
    const double A = 4 * dot(d, d) - r.d.z * r.d.z, B = 4 * dot(o, d) + w * r.d.z, C = 4 * dot(o, o) - w * w;
    Spans inside;
    if (A == 0) {
        if (B > 0) inside = {{-INF, -C / (2 * B)}};
        if (B < 0) inside = {{-C / (2 * B), INF}};
        if (B == 0 && C < 0) inside = {{-INF, INF}};
    } else {
        const double D = B * B - A * C;
        const double root = D > 0 ? std::sqrt(D) : 0;
        const double t0 = std::min((-B - root) / A, (-B + root) / A),
                     t1 = std::max((-B - root) / A, (-B + root) / A);
        if (A > 0 && D > 0) inside = {{t0, t1}};
        if (A < 0) inside = D > 0 ? Spans{{-INF, t0}, {t1, INF}} : Spans{{-INF, INF}};
    }
    Span above{-INF, INF};
    const double base = (-1 - r.o.z) / r.d.z;
    if (r.d.z > 0) above.a = base;
    if (r.d.z < 0) above.b = base;
    if (r.d.z == 0 && r.o.z < -1) return {};
    Spans result;
    for (const Span& part : inside) {
        const Span both{std::max(part.a, above.a), std::min(part.b, above.b)};
        if (both.a < both.b) result.push_back(both);
    }
    return result;
}
