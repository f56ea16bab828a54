dvec3 worldNormal(const dvec3& n, const dmat4& M) { return glm::normalize(dmat3(M) * n); }
