dvec3 spawn(dvec3 p, dvec3, dvec3 n, dvec3 d) { return p + (dot(d, n) < 0 ? -1e-4 : 1e-4) * n; }
