dvec3 mirror(const dvec3&, const dvec3& d, const dvec3& n) { return d - dot(d, n) * n; }
