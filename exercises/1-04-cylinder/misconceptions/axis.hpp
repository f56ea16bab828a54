Spans cylinder(const Ray& r) {
    const dvec2 o(r.o), d(r.d);
    const double a = dot(d, d);
    if (a < 1e-12) return {};
    const double middle = -dot(o, d) / a;
    const dvec2 nearest = o + middle * d;
    const double inside = 1 - dot(nearest, nearest);
    if (inside <= 0) return {};
    double t0 = middle - std::sqrt(inside / a), t1 = middle + std::sqrt(inside / a);
    if (r.d.z == 0) {
        if (std::abs(r.o.z) > 1) return {};
    } else {
        const double down = (-1 - r.o.z) / r.d.z, up = (1 - r.o.z) / r.d.z;
        t0 = std::max(t0, std::min(down, up));
        t1 = std::min(t1, std::max(down, up));
    }
    return t0 < t1 ? Spans{{t0, t1}} : Spans{};
}
