#include "cases.hpp"

void cases(Cases& c) {
    const auto stretch = [&] { return Cases::scale({c.between(2, 4), c.between(0.2, 0.5), 1}); };
    const auto slanted = [&] {
        return glm::normalize(dvec3(c.sign(), c.sign(), c.sign()) * c.vector(0.4, 1));
    };
    c.group("basic");
    for (int i = 0; i < 2; ++i) c.add("rotation", c.unit(), c.rotation());
    c.add("translation", c.unit(), c.translation());
    c.add("translation and rotation", c.unit(), c.translation() * c.rotation());
    c.group("edge");
    for (int i = 0; i < 2; ++i) c.add("unequal scale", slanted(), stretch());
    c.add("unequal scale and rotation", slanted(), c.rotation() * stretch());
    c.group("hard");
    c.add("shear", slanted(), c.shear());
    c.add("mirror", slanted(), c.rotation() * Cases::scale({-1, 1, 1}));
    c.add("mirror and shear", slanted(), Cases::scale({1, -c.between(1, 2), 1}) * c.shear());
    c.add("scales of 1e-3, 1 and 1e3", slanted(), c.rotation() * Cases::scale({1e-3, 1, 1e3}));
}

/// A ray onto the place of the moved unit sphere where its normal is n.
Shown show(const dvec3& n, const dmat4& M) {
    const dvec3 place(M * dvec4(n, 1)), outward = glm::normalize(glm::transpose(glm::inverse(dmat3(M))) * n);
    return {scene(generic("ball", "sphere", M), place + 6.0 * outward, place),
            {place + 3.0 * outward, -outward}};
}
