std::optional<dvec2> chord(const Ray& r, dvec3 c, double R) {
    const double a = dot(r.d, r.d), middle = dot(c - r.o, r.d) / a;
    const dvec3 nearest = r.o + middle * r.d - c;
    const double inside = R * R - dot(nearest, nearest);
    if (inside <= 0) return std::nullopt;
    return dvec2(middle, std::sqrt(inside));
}
