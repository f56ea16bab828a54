dvec3 worldNormal(const dvec3& n, const dmat4& M) { return glm::normalize(glm::inverse(dmat3(M)) * n); }
