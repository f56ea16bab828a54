#include "cases.hpp"

void cases(Cases& c) {
    const double water = 0.7519, glass = c.between(0.6, 0.7), diamond = c.between(0.4, 0.45);
    const auto both = [&](const char* about, double c1, double c2) {
        c.function(0);
        c.add(about, c1, c2);
        c.function(1);
        c.add(about, c1, c2);
    };
    c.group("basic");
    both("water to air", water, 1.0);
    both("glass to air", glass, 1.0);
    both("diamond to water", diamond, water);
    c.group("edge");
    both("air to water", 1.0, water);
    both("water to glass", water, glass);
    both("equal speeds", glass, glass);
    c.group("hard");
    both("c1/c2 = 0.999999", 0.999999 * glass, glass);
    both("c1/c2 = 1e-3", 1e-3 * glass, glass);
    both("c1/c2 = 1.000001", 1.000001 * glass, glass);
}
