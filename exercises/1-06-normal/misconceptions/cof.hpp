dvec3 worldNormal(const dvec3& n, const dmat4& M) {
    const dmat3 m(M);
    return glm::normalize(glm::determinant(m) * (glm::transpose(glm::inverse(m)) * n));
}
