#include "cases.hpp"

namespace {

/// Its line runs through a point inside the cone, off the axis.
dvec3 inside(Cases& c) {
    const double z = c.between(-0.8, 0.3), angle = c.between(0, 6.28),
                 radius = c.between(0.2, 0.8) * (1 - z) / 2;
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}
dvec3 slanted(Cases& c, double least, double most) {
    const double angle = c.between(0, 6.28);
    return {std::cos(angle), std::sin(angle), c.sign() * c.between(least, most)};
}
Ray through(Cases& c, const dvec3& point, const dvec3& d) { return {point - c.between(2, 4) * d, d}; }

/// Parallel to the slope, in numbers that are exact: 4(x² + y²) = z².
dvec3 along_slope(Cases& c) {
    static const std::vector<dvec3> directions{{1, 0, 2}, {0, 1, 2}, {3, 4, 10}, {4, 3, 10}};
    dvec3 d = directions[static_cast<std::size_t>(c.whole(0, 3))];
    d.x *= c.sign(), d.y *= c.sign(), d.z *= c.sign();
    return d;
}
dvec3 eighths(Cases& c) { return {c.whole(-2, 2) / 8.0, c.whole(1, 3) / 8.0, -c.whole(1, 4) / 8.0}; }

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 3; ++i) c.add("across", through(c, inside(c), slanted(c, 0, 0.5)));
    c.add("passes by", through(c, {0, c.between(1.2, 2), c.between(-0.5, 0.5)}, {1, 0, 0}));
    c.group("edge");
    for (int i = 0; i < 3; ++i) c.add("steep", through(c, inside(c), slanted(c, 4, 8)));
    c.add("steep, in by the base", through(c, {c.between(0.1, 0.3), 0, -1}, {0.1, 0.1, c.between(1, 2)}));
    c.add("over the apex", through(c, {0, c.between(-0.2, 0.2), c.between(1.5, 2)}, {1, 0, 0}));
    c.group("hard");
    for (int i = 0; i < 2; ++i) {
        const dvec3 d = along_slope(c);
        c.add("parallel to the slope", Ray{eighths(c) - 2.0 * d, d});
    }
    const dvec3 flat(c.whole(1, 3), c.whole(-3, -1), -1), steep(1, c.whole(-1, 1), -c.whole(5, 8));
    c.add("through the apex, beside the cone", Ray{dvec3(0, 0, 1) - 2.0 * flat, flat});
    c.add("through the apex, into the cone", Ray{dvec3(0, 0, 1) - 2.0 * steep, steep});
    c.add("up the axis", Ray{{0, 0, -c.whole(3, 6)}, {0, 0, 1}});
}

/// The cone, and where the answer says that the ray is inside.
Shown show(const Ray& r, const Spans&, const Spans& answer) {
    return {scene(answer_solids(r, answer) + generic("cone", "cone", dmat4(1), "clear")), r};
}
