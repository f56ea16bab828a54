Wall wall(dvec3 d, dvec3 nOut, double c) {
    const bool enters = dot(d, nOut) < 0;
    return {enters ? nOut : -nOut, enters ? 1 : c, enters ? c : 1, enters, false};
}
