#include "cases.hpp"

namespace {

dvec2 flat_unit(Cases& c) {
    const double angle = c.between(0, 6.28);
    return {std::cos(angle), std::sin(angle)};
}

/// From one point to another, and beyond.
Ray through(Cases& c, const dvec3& from, const dvec3& to) {
    const double length = c.between(0.5, 2), back = c.between(1, 3);
    return {from - back * (to - from), length * (to - from)};
}

dvec3 on_cap(Cases& c, double z) { return {c.between(0.1, 0.7) * flat_unit(c), z}; }
dvec3 on_side(Cases& c) { return {flat_unit(c), c.between(-0.7, 0.7)}; }

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 2; ++i) {
        const dvec2 d = flat_unit(c), across(-d.y, d.x);
        const dvec3 middle(c.between(-0.8, 0.8) * across, c.between(-0.6, 0.6));
        c.add("across", Ray{middle - c.between(2, 4) * dvec3(d, 0), {d, 0}});
    }
    for (int i = 0; i < 2; ++i) c.add("from a cap to the side", through(c, on_cap(c, c.sign()), on_side(c)));
    c.add("from cap to cap", through(c, on_cap(c, 1), on_cap(c, -1)));
    c.add("passes above", Ray{{-3, c.between(-0.5, 0.5), c.between(1.2, 2)}, {1, 0, 0}});
    c.group("edge");
    c.add("along the axis, inside",
          Ray{{c.between(0.1, 0.6), c.between(0.1, 0.6), c.between(2, 4)}, {0, 0, -1}});
    c.add("along the axis, starts inside", Ray{{c.between(0.1, 0.6), c.between(-0.6, -0.1), 0}, {0, 0, 2}});
    c.add("along the axis, outside", Ray{{c.between(1.1, 2), 0, c.between(2, 4)}, {0, 0, -1}});
    const double side = c.sign();
    c.add("through a point of the rim", Ray{{0, 0, 2 * side}, {c.sign(), 0, -side}});
    c.add("cuts the rim", Ray{{0, 0, c.between(1.2, 1.8) * side}, {0, c.sign(), -side}});
    c.add("the solid lies behind",
          Ray{{c.between(3, 5), c.between(-0.5, 0.5), 0}, {1, 0, c.between(-0.1, 0.1)}});
    c.group("hard");
    c.add("d.xy = 1e-9", Ray{{c.between(-0.5, 0.5), c.between(-0.5, 0.5), 3}, {1e-9, -1e-9, -1}});
    c.add("d.xy = 1e-9, outside", Ray{{1.5, c.between(-0.5, 0.5), 3}, {0, 1e-9, -1}});
    c.add("just under a cap", Ray{{-3, c.between(-0.5, 0.5), c.sign() * (1 - 1e-9)}, {1, 0, 0}});
    c.add("just above a cap", Ray{{-3, c.between(-0.5, 0.5), c.sign() * (1 + 1e-9)}, {1, 0, 0}});
}

/// The cylinder, and where the answer says that the ray is inside.
Shown show(const Ray& r, const Spans&, const Spans& answer) {
    return {scene(answer_solids(r, answer) + generic("can", "cylinder", dmat4(1), "clear")), r};
}
