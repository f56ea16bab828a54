Spans cylinder(const Ray& r) {
    const dvec2 o(r.o), d(r.d);
    const double a = dot(d, d);
    if (a == 0) return dot(o, o) < 1 ? Spans{{-INF, INF}} : Spans{};
    const double middle = -dot(o, d) / a;
    const dvec2 nearest = o + middle * d;
    const double inside = 1 - dot(nearest, nearest);
    if (inside <= 0) return {};
    return {{middle - std::sqrt(inside / a), middle + std::sqrt(inside / a)}};
}
