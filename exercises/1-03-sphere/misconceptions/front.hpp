Spans sphere(const Ray& r) {
    const double a = dot(r.d, r.d), b = dot(r.o, r.d), c = dot(r.o, r.o) - 1, D = b * b - a * c;
    if (D <= 0) return {};
    const double t0 = (-b - std::sqrt(D)) / a, t1 = (-b + std::sqrt(D)) / a;
    if (t1 < 0) return {};
    return {{std::max(t0, 0.0), t1}};
}
