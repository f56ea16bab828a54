Spans cylinder(const Ray& r) {
    const dvec2 o(r.o), d(r.d);
    const double a = dot(d, d);
    if (a == 0) return {};
    const double middle = -dot(o, d) / a;
    const dvec2 nearest = o + middle * d;
    const double inside = 1 - dot(nearest, nearest);
    if (inside <= 0) return {};
    const double t0 = middle - std::sqrt(inside / a), t1 = middle + std::sqrt(inside / a);
    const bool first = std::abs(r.o.z + t0 * r.d.z) <= 1, second = std::abs(r.o.z + t1 * r.d.z) <= 1;
    return first && second ? Spans{{t0, t1}} : Spans{};
}
