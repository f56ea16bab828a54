double fresnel(double c1, double c2, double cosI) {
    const double eta = c2 / c1, k = 1 - eta * eta * (1 - cosI * cosI);
    if (k < 0) return 1;
    const double root = (c1 - c2) / (c1 + c2);
    return root * root;
}
