#include "cases.hpp"

namespace {

constexpr double glass = 1 / 1.5;

void add(Cases& c, const char* about, double degrees, double c1, double c2) {
    const dvec3 n = c.unit();
    const double angle = degrees * 3.14159265358979323846 / 180;
    c.add(about, std::sin(angle) * c.across(n) - std::cos(angle) * n, n, c1, c2);
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    c.add("30° into glass", dvec3(0.5, 0, -std::sqrt(0.75)), dvec3(0, 0, 1), 1.0, glass);
    add(c, "45° into glass", 45, 1, glass);
    add(c, "20° out of glass", 20, glass, 1);
    add(c, "from medium to medium", c.between(10, 30), c.between(0.7, 0.8), c.between(0.5, 0.65));
    c.group("edge");
    add(c, "normal incidence", 0, 1, glass);
    add(c, "equal speeds", c.between(20, 70), 0.75, 0.75);
    add(c, "60° out of glass", 60, glass, 1);
    add(c, "89.9° into glass", 89.9, 1, glass);
    c.group("hard");
    add(c, "41.80° out of glass", 41.80, glass, 1);
    add(c, "41.82° out of glass", 41.82, glass, 1);
    add(c, "1e-7° into glass", 1e-7, 1, glass);
    add(c, "89.999999° into glass", 89.999999, 1, glass);
}

/// The boundary as the face of a half space; the scene around it is medium 1.
Shown show(const dvec3& d, const dvec3& n, double c1, double c2) {
    return {"[scene]\nmedium = { speed = " + digits(c1) +
                " }\n\n[materials.medium2]\ntransmission = 0.9\nspeed = " + digits(c2) + "\n\n" +
                scene(generic("below", "plane", facing(dvec3(0), n), "medium2"), 6.0 * n + 4.0 * d),
            {-3.0 * d, d}};
}
