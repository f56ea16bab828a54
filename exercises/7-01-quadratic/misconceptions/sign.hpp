std::vector<double> roots(double a, double b, double c) {
    if (a == 0) return b == 0 ? std::vector<double>{} : std::vector<double>{-c / b};
    const double D = b * b - 4 * a * c;
    if (D < 0) return {};
    if (D == 0) return {-b / (2 * a)};
    const double q = -(b + std::sqrt(D)) / 2;
    return {std::min(q / a, c / q), std::max(q / a, c / q)};
}
