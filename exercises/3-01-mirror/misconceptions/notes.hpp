dvec3 mirror(const dvec3& p, const dvec3&, const dvec3& n) { return p - 2 * dot(p, n) * n; }
