dvec3 mirror(const dvec3&, const dvec3& d, const dvec3& n) { return glm::normalize(d - 2 * dot(d, n) * n); }
