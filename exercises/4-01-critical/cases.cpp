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

namespace {

/// A ray onto the boundary at this angle; below it the speed is c2.
Shown boundary(double c1, double c2, double angle) {
    const dvec3 d(std::sin(angle), 0, -std::cos(angle));
    return {"[scene]\nmedium = { speed = " + digits(c1) +
                " }\n\n[materials.medium2]\ntransmission = 0.9\nspeed = " + digits(c2) + "\n\n" +
                scene(generic("below", "plane", dmat4(1), "medium2"), {2, -5, 3}),
            {-3.0 * d, d}};
}

} // namespace

/// The answer as the speed below that would have this index.
Shown show_index21(double c1, double c2, double right, double answer) {
    Shown shown = boundary(c1, answer == right ? c2 : c1 / answer, c1 < c2 ? std::asin(c1 / c2) / 2 : 0.8);
    shown.note = "The case has no ray. This one shows how much a medium of this index bends light.";
    return shown;
}

/// The answer as the speed below that would have this critical angle. The ray comes between that angle and 90°.
Shown show_critical(double c1, double c2, std::optional<double> right, std::optional<double> answer) {
    const double other = answer ? c1 / std::sin(*answer) : c1;
    Shown shown = boundary(c1, answer == right ? c2 : other,
                           right ? (*right + std::numbers::pi / 2) / 2 : 80 * std::numbers::pi / 180);
    shown.note = right ? "The case has no ray. This one comes from beyond the critical angle."
                       : "The case has no ray. This one comes at 80°, and goes through all the same.";
    return shown;
}
