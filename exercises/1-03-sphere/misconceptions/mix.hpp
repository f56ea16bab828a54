Spans sphere(const Ray& r) {
    const double a = dot(r.d, r.d), b = dot(r.o, r.d), c = dot(r.o, r.o) - 1, D = b * b - 4 * a * c;
    if (D <= 0) return {};
    return {{(-b - std::sqrt(D)) / a, (-b + std::sqrt(D)) / a}};
}
