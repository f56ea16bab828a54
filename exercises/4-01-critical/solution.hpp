#include "rx.hpp"
using namespace rx;

double index21(double c1, double c2) { return c1 / c2; }

std::optional<double> critical(double c1, double c2) {
    if (c1 >= c2) return std::nullopt;
    return std::asin(c1 / c2);
}
