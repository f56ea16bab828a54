#include "cases.hpp"

namespace {

/// A ray whose line passes the centre at `distance`; it starts `before` in front of the nearest point.
Ray passing(Cases& c, double distance, double before, double length) {
    const dvec3 d = c.unit();
    return {distance * c.across(d) - before * d, length * d};
}

/// Exactly a tangent: along an axis.
Ray tangent(Cases& c, double length) {
    Ray ray;
    const int axis = c.whole(0, 2);
    ray.o[axis] = c.whole(-4, 4);
    ray.o[(axis + 1) % 3] = c.sign();
    ray.d[axis] = c.sign() * length;
    return ray;
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 3; ++i)
        c.add("through the sphere", passing(c, c.between(0, 0.9), c.between(2, 6), 1));
    c.add("past the sphere", passing(c, c.between(1.2, 3), c.between(2, 6), 1));
    c.group("edge");
    c.add("|d| = 2", passing(c, c.between(0, 0.9), c.between(2, 6), 2));
    c.add("|d| = 1e-3", passing(c, c.between(0, 0.9), c.between(2, 6), 1e-3));
    c.add("starts inside", passing(c, c.between(0, 0.5), c.between(-0.5, 0.5), 1));
    c.add("the sphere lies behind", passing(c, c.between(0, 0.9), -c.between(2, 6), 1));
    c.add("touches", tangent(c, 1));
    c.add("touches, |d| = 2", tangent(c, 2));
    c.group("hard");
    c.add("grazes", passing(c, 1 - 1e-6, c.between(1, 2), 1));
    c.add("grazes outside", passing(c, 1 + 1e-6, c.between(1, 2), 1));
    c.add("oblique, |d| = 7", passing(c, c.between(0.5, 0.95), c.between(1, 3), 7));
    c.add("starts on the sphere", Ray{c.unit(), c.between(1, 3) * c.unit()});
}

Shown show(const Ray& r) { return {scene(generic("ball", "sphere")), r}; }
