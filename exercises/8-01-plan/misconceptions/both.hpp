unsigned plan(const Mat& m, int k, double, double, bool inside) {
    unsigned bits = 0;
    if (!inside) bits |= 1U;
    if (k > 0) bits |= 2U | 4U;
    if (!inside && m.kd + m.ks > 0) bits |= 8U;
    return bits;
}
