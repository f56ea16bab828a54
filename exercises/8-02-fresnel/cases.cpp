#include "cases.hpp"

namespace {

constexpr double glass = 1 / 1.5;
double cosine(double degrees) { return std::cos(degrees * 3.14159265358979323846 / 180); }

} // namespace

void cases(Cases& c) {
    c.group("basic");
    c.add("0°, glass", 1.0, glass, 1.0);
    c.add("45°, glass", 1.0, glass, cosine(45));
    c.add("into glass", 1.0, c.between(0.6, 0.7), cosine(c.between(40, 70)));
    c.add("equal speeds", 0.75, 0.75, cosine(c.between(10, 60)));
    c.group("edge");
    c.add("total internal reflection", glass, 1.0, cosine(c.between(50, 80)));
    c.add("leaving glass", glass, 1.0, cosine(c.between(20, 38)));
    c.add("80°", 1.0, c.between(0.6, 0.7), cosine(80));
    c.add("from water into glass", 0.75, glass, cosine(c.between(50, 80)));
    c.group("hard");
    c.add("leaving glass at 41.8°", glass, 1.0, cosine(41.8));
    c.add("89.9°", 1.0, c.between(0.6, 0.7), cosine(89.9));
    c.add("c2 = 0.99999", 1.0, 0.99999, cosine(c.between(70, 85)));
    c.add("leaving glass at 40°", glass, 1.0, cosine(40));
}

/// The boundary as the face of a half space, met at the angle given; the scene around it is medium 1.
Shown show(double c1, double c2, double cosI) {
    const dvec3 d(std::sqrt(std::max(0.0, 1 - cosI * cosI)), 0, -cosI);
    return {"[scene]\nmedium = { speed = " + digits(c1) +
                " }\n\n[materials.medium2]\nfresnel = true\nspeed = " + digits(c2) + "\n\n" +
                scene(generic("below", "plane", dmat4(1), "medium2"), {2, -5, 3}),
            {-3.0 * d, d}};
}
