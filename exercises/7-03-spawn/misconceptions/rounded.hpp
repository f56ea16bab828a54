dvec3 spawn(dvec3 p, dvec3 err, dvec3 n, dvec3 d) {
    const double bound = dot(glm::abs(n), err);
    return p + (dot(d, n) < 0 ? -bound : bound) * n;
}
