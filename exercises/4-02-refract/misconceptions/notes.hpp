std::optional<dvec3> refract(dvec3 d, dvec3 n, double c1, double c2) {
    const double eta = c2 / c1, cosine = dot(n, d), k = 1 - eta * eta * (1 - cosine * cosine);
    if (k < 0) return std::nullopt;
    return eta * d + (eta * cosine - std::sqrt(k)) * n;
}
