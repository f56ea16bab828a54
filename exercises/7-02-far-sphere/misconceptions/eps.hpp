std::optional<dvec2> chord(const Ray& r, dvec3 c, double R) {
    const dvec3 v = r.o - c;
    const double a = dot(r.d, r.d), b = dot(v, r.d), C = dot(v, v) - R * R, D = b * b - a * C;
    if (D <= -1e-6) return std::nullopt;
    return dvec2(-b / a, std::sqrt(std::max(D, 0.0)) / a);
}
