double fresnel(double c1, double c2, double cosI) {
    const double eta = c1 / c2, k = 1 - eta * eta * (1 - cosI * cosI);
    if (k < 0) return 1;
    const double n1 = 1 / c1, n2 = 1 / c2, cosT = std::sqrt(k);
    const double rs = (n1 * cosI - n2 * cosT) / (n1 * cosI + n2 * cosT);
    const double rp = (n2 * cosI - n1 * cosT) / (n2 * cosI + n1 * cosT);
    return (rs * rs + rp * rp) / 2;
}
