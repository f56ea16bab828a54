Spans cone(const Ray& r) {
    const dvec2 o(r.o), d(r.d);
    const double w = 1 - r.o.z;
    const double A = 4 * dot(d, d) - r.d.z * r.d.z, B = 4 * dot(o, d) + w * r.d.z, C = 4 * dot(o, o) - w * w;
    double t0 = -INF, t1 = INF;
    if (A == 0) {
        if (B > 0) t1 = -C / (2 * B);
        if (B < 0) t0 = -C / (2 * B);
        if (B == 0 && C >= 0) return {};
    } else {
        const double D = B * B - A * C;
        if (D <= 0) return {};
        const double root = std::sqrt(D);
        t0 = std::min((-B - root) / A, (-B + root) / A);
        t1 = std::max((-B - root) / A, (-B + root) / A);
    }
    if (r.d.z == 0) {
        if (std::abs(r.o.z) > 1) return {};
    } else {
        const double down = (-1 - r.o.z) / r.d.z, up = (1 - r.o.z) / r.d.z;
        t0 = std::max(t0, std::min(down, up));
        t1 = std::min(t1, std::max(down, up));
    }
    return t0 < t1 ? Spans{{t0, t1}} : Spans{};
}
