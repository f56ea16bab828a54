double size(const dvec3& v) { return dot(v, v); }
