#include "cases.hpp"

namespace {

/// Passes the centre at `distance`; starts `before` in front of the nearest point.
Ray passing(Cases& c, const dvec3& centre, double distance, double before, double length) {
    const dvec3 d = c.unit();
    return {centre + distance * c.across(d) - before * d, length * d};
}

/// In whole numbers, so that every formula without cancellation is exact: `steps` times d away.
Ray far(Cases& c, const dvec3& centre, double steps) {
    const dvec3 d(c.whole(1, 4), c.whole(-4, -1), c.whole(1, 3)), across(d.y, -d.x, 0);
    return {centre + across - steps * d, d};
}

} // namespace

void cases(Cases& c) {
    const dvec3 centre = c.vector(-3, 3);
    const double R = c.between(1, 3);
    c.group("basic");
    for (int i = 0; i < 3; ++i)
        c.add("near", passing(c, centre, c.between(0.1, 0.9) * R, c.between(4, 8), 1), centre, R);
    c.add("misses", passing(c, centre, c.between(1.2, 2) * R, c.between(4, 8), 1), centre, R);
    c.group("edge");
    c.add("|d| = 3", passing(c, centre, c.between(0.1, 0.9) * R, c.between(4, 8), 3), centre, R);
    c.add("|d| = 0.01", passing(c, centre, c.between(0.1, 0.9) * R, c.between(4, 8), 0.01), centre, R);
    c.add("starts at the centre", Ray{centre, c.between(0.3, 3) * c.unit()}, centre, R);
    c.add("lies behind", passing(c, centre, c.between(0.1, 0.9) * R, -c.between(4, 8), 2), centre, R);
    c.group("hard");
    const dvec3 whole(c.whole(-9, 9), c.whole(-9, 9), c.whole(-9, 9));
    for (const double distance : {1e9, 1e10}) {
        c.add(distance == 1e9 ? "about 1e9 away" : "about 1e10 away", far(c, whole, distance), whole,
              c.whole(7, 12));
        c.add("far, near the rim", far(c, whole, distance), whole, 5.75);
    }
    c.add("a near miss", Ray{{1 + c.between(1e-8, 2e-8), 0, c.between(4, 8)}, {0, 0, -1}}, dvec3(0), 1.0);
}

/// The ball, and where the answer says that the ray is inside.
Shown show(const Ray& r, const dvec3& centre, double R, const std::optional<dvec2>&,
           const std::optional<dvec2>& answer) {
    const Spans chord = answer ? Spans{{answer->x - answer->y, answer->x + answer->y}} : Spans{};
    return {
        scene(answer_solids(r, chord) +
                  generic("ball", "sphere", glm::scale(glm::translate(dmat4(1), centre), dvec3(R)), "clear"),
              centre + 4 * R * dvec3(1, 1, 2), centre),
        r};
}
