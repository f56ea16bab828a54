#include "cases.hpp"

void cases(Cases& c) {
    const auto ray = [&] { return Ray{c.vector(-5, 5), c.unit()}; };
    c.group("basic");
    for (int i = 0; i < 2; ++i) c.add("translation", ray(), c.translation());
    for (int i = 0; i < 2; ++i) c.add("translation and rotation", ray(), c.translation() * c.rotation());
    c.group("edge");
    c.add("scale", ray(), Cases::scale(dvec3(c.between(2, 4))));
    c.add("unequal scale", ray(), Cases::scale({c.between(2, 4), c.between(0.2, 0.5), c.between(1.5, 3)}));
    c.add("translation, rotation, scale", ray(),
          c.translation() * c.rotation() * Cases::scale(c.vector(0.3, 3)));
    c.group("hard");
    c.add("shear", ray(), c.translation() * c.shear());
    c.add("mirror", ray(), c.rotation() * Cases::scale({-c.between(1, 2), 1, c.between(0.5, 1)}));
    c.add("scale of 1e-4", ray(), c.translation() * Cases::scale(dvec3(1e-4)));
}

/// A ball with the shape that M gives it, on the ray's way: where M puts it the ray may miss it.
Shown show(const Ray& r, const dmat4& M) {
    dmat4 met = M;
    met[3] = dvec4(r.o + 6.0 * r.d, 1);
    return {scene(generic("ball", "sphere", met)), r};
}
