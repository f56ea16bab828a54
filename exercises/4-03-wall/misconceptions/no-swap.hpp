Wall wall(dvec3 d, dvec3 nOut, double c) {
    const bool enters = dot(d, nOut) < 0;
    Wall result{enters ? nOut : -nOut, 1, c, enters, false};
    const double eta = c, cosine = dot(d, nOut);
    result.tir = 1 - eta * eta * (1 - cosine * cosine) < 0;
    return result;
}
