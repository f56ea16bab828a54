#include "cases.hpp"

namespace {

struct Coefficients {
    double a, b, c;
};
/// With these roots.
Coefficients with(double a, double t0, double t1) { return {a, -a * (t0 + t1), a * t0 * t1}; }

} // namespace

void cases(Cases& c) {
    const auto add = [&](const char* about, const Coefficients& k) { c.add(about, k.a, k.b, k.c); };
    c.group("basic");
    add("two positive roots", with(c.between(1, 2), c.between(1, 2), c.between(3, 4)));
    add("two negative roots", with(c.between(1, 2), -c.between(3, 4), -c.between(1, 2)));
    add("one of each sign", with(c.between(1, 2), -c.between(1, 2), c.between(3, 4)));
    c.add("none", c.between(1, 2), c.between(0.1, 0.5), c.between(1, 2));
    c.group("edge");
    c.add("a = 0", 0.0, c.between(1, 2), c.between(1, 2));
    c.add("a = 0 and b = 0", 0.0, 0.0, c.between(1, 2));
    c.add("all 0", 0.0, 0.0, 0.0);
    add("a < 0", with(-c.between(1, 2), c.between(1, 2), c.between(3, 4)));
    c.add("b = 0", c.between(1, 2), 0.0, -c.between(1, 2));
    c.add("c = 0, b < 0", c.between(1, 2), -c.between(1, 2), 0.0);
    c.add("c = 0, b > 0", c.between(1, 2), c.between(1, 2), 0.0);
    const double root = c.whole(-8, 8);
    c.add("a double root", 2.0, -4 * root, 2 * root * root);
    c.group("hard");
    c.add("b = 1e9", 1.0, 1e9, c.between(1, 2));
    c.add("b = -1e9", 1.0, -1e9, c.between(1, 2));
    c.add("a = 1e-9, b = 1e9", 1e-9, 1e9, -c.between(1, 2));
    c.add("a = 1e-9, b = -1e9", 1e-9, -1e9, c.between(1, 2));
}
