double index21(double c1, double c2) { return c1 / c2; }

std::optional<double> critical(double c1, double c2) {
    if (c2 >= c1) return std::nullopt;
    return std::asin(c2 / c1);
}
