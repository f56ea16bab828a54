dvec3 spawn(dvec3 p, dvec3, dvec3, dvec3 d) { return p + 1e-4 * d; }
