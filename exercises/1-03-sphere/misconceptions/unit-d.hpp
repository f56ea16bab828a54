Spans sphere(const Ray& r) {
    const double b = dot(r.o, r.d), c = dot(r.o, r.o) - 1, D = b * b - c;
    if (D <= 0) return {};
    return {{-b - std::sqrt(D), -b + std::sqrt(D)}};
}
