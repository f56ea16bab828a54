#include "cases.hpp"

namespace {

Ray ray(Cases& c, double height, double dz) {
    return {{c.between(-3, 3), c.between(-3, 3), height}, {c.between(0.3, 1), c.between(-1, -0.3), dz}};
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 2; ++i) {
        c.add("goes down", ray(c, c.between(0.5, 4), -c.between(0.2, 1)));
        c.add("goes up, from below", ray(c, -c.between(0.5, 4), c.between(0.2, 1)));
    }
    c.group("edge");
    c.add("parallel, below", ray(c, -c.between(0.5, 4), 0));
    c.add("parallel, above", ray(c, c.between(0.5, 4), 0));
    c.add("in the plane", ray(c, 0, 0));
    c.add("goes up, the plane lies behind", ray(c, c.between(0.5, 4), c.between(0.2, 1)));
    c.add("goes down, the plane lies behind", ray(c, -c.between(0.5, 4), -c.between(0.2, 1)));
    c.group("hard");
    c.add("d.z = -1e-9", ray(c, c.between(0.5, 4), -1e-9));
    c.add("d.z = 1e-9", ray(c, -c.between(0.5, 4), 1e-9));
    c.add("d.z = -0.0, below", ray(c, -c.between(0.5, 4), -0.0));
    c.add("d.z = -0.0, above", ray(c, c.between(0.5, 4), -0.0));
}

/// The half space, and where the answer says that the ray is inside.
Shown show(const Ray& r, const Spans&, const Spans& answer) {
    return {scene(answer_solids(r, answer) + generic("ground", "plane", dmat4(1), "clear")), r};
}
