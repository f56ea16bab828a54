#include "cases.hpp"

namespace {

Box box(Cases& c) {
    const dvec3 lo = c.vector(-2, 0);
    return {lo, lo + c.vector(1, 3)};
}
dvec3 within(Cases& c, const Box& b) { return b.lo + (b.hi - b.lo) * c.vector(0.2, 0.8); }

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 3; ++i) {
        const Box b = box(c);
        const dvec3 d = c.vector(0.3, 1);
        c.add("hits", Ray{within(c, b) - c.between(6, 9) * d, d}, b);
    }
    const Box b = box(c);
    c.add("misses", Ray{{b.lo.x - 3, b.hi.y + c.between(1, 2), b.lo.z}, {1, 0.1, 0.1}}, b);
    c.group("edge");
    const dvec3 down = -c.vector(0.3, 1);
    c.add("d < 0", Ray{within(c, b) - c.between(6, 9) * down, down}, b);
    const dvec3 mixed = c.vector(0.3, 1) * dvec3(1, -1, c.sign());
    c.add("mixed signs", Ray{within(c, b) - c.between(6, 9) * mixed, mixed}, b);
    c.add("starts inside", Ray{within(c, b), c.vector(0.3, 1)}, b);
    c.add("parallel to z", Ray{dvec3(dvec2(within(c, b)), b.hi.z + 2), {0, 0, -1}}, b);
    c.add("parallel to x, beside the box",
          Ray{{b.lo.x - 2, b.hi.y + c.between(0.5, 1), within(c, b).z}, {1, 0, 0}}, b);
    const dvec3 away = c.vector(0.3, 1);
    c.add("the box lies behind", Ray{within(c, b) + c.between(6, 9) * away, away}, b);
    c.group("hard");
    const dvec3 middle = within(c, b);
    c.add("in the plane of a face, d.y = 0",
          Ray{{b.lo.x - 1, b.lo.y, middle.z}, {1, 0, c.between(-0.1, 0.1)}}, b);
    c.add("in the plane of a face, d.y = -0.0", Ray{{b.lo.x - 1, b.lo.y, middle.z}, {1, -0.0, 0}}, b);
    c.add("in the plane of the other face, d.y = 0", Ray{{b.lo.x - 1, b.hi.y, middle.z}, {1, 0.0, 0}}, b);
    c.add("in the plane of the other face, d.y = -0.0", Ray{{b.lo.x - 1, b.hi.y, middle.z}, {1, -0.0, 0}}, b);
    const Box flat{{b.lo.x, 0.5, b.lo.z}, {b.hi.x, 0.5, b.hi.z}};
    c.add("through a flat box", Ray{{middle.x, 3, middle.z}, {0.01, -1, 0.01}}, flat);
    c.add("along a flat box", Ray{{b.lo.x - 1, 0.5, middle.z}, {1, 0, 0.01}}, flat);
    c.add("beside a flat box", Ray{{b.lo.x - 1, 0.75, middle.z}, {1, 0, 0.01}}, flat);
}

/// The box as a cube; what is flat is as thin as can be seen. And where the answer says that the ray is inside.
Shown show(const Ray& r, const Box& b, const std::optional<Span>&, const std::optional<Span>& answer) {
    const dvec3 half = glm::max((b.hi - b.lo) / 2.0, dvec3(0.001)), middle = (b.lo + b.hi) / 2.0;
    return {scene(answer_solids(r, answer ? Spans{*answer} : Spans{}) +
                      generic("box", "cube", glm::scale(glm::translate(dmat4(1), middle), half), "clear"),
                  middle + dvec3(5, 4, 7), middle),
            r};
}
