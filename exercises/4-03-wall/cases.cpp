#include "cases.hpp"

namespace {

constexpr double glass = 1 / 1.5;

/// The ray meets the wall at so many degrees, from outside or from inside.
void add(Cases& c, const char* about, double degrees, bool enters, double speed) {
    const dvec3 n = c.unit();
    const double angle = degrees * 3.14159265358979323846 / 180;
    c.add(about, std::sin(angle) * c.across(n) + (enters ? -1.0 : 1.0) * std::cos(angle) * n, n, speed);
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 2; ++i) {
        add(c, "into glass", c.between(10, 80), true, glass);
        add(c, "out of glass", c.between(5, 35), false, glass);
    }
    c.group("edge");
    add(c, "out of glass at 60°", 60, false, glass);
    add(c, "out of glass at 0°", 0, false, glass);
    add(c, "into glass at 60°", 60, true, glass);
    add(c, "into glass at 0°", 0, true, glass);
    c.group("hard");
    add(c, "out of glass at 41.80°", 41.80, false, glass);
    add(c, "out of glass at 41.82°", 41.82, false, glass);
    add(c, "out, c = 0.9999, grazing", 89.5, false, 0.9999);
    add(c, "out, c = 0.9999", 89, false, 0.9999);
    add(c, "in, c = 1.25, beyond the critical angle", c.between(60, 80), true, 1.25);
    add(c, "out, c = 1.25", c.between(60, 80), false, 1.25);
}

/// A ball, met where its normal is nOut, from outside or from inside.
Shown show(const dvec3& d, const dvec3& nOut, double speed) {
    return {"[materials.inner]\ntransmission = 0.9\nspeed = " + digits(speed) + "\n\n" +
                scene(generic("ball", "sphere", dmat4(1), "inner")),
            {nOut - (dot(d, nOut) < 0 ? 3.0 : 0.01) * d, d}};
}
