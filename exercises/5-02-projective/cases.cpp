#include "cases.hpp"

namespace {

/// Somewhere, turned about the vertical; `view` is its inverse.
struct Eye {
    dmat4 to_world;
    Cam camera;
};
Eye eye(Cases& c, bool moved) {
    dmat4 pose(1);
    if (moved) pose = glm::rotate(c.translation(3), c.between(-3, 3), dvec3(0, 1, 0));
    return {pose, {glm::inverse(pose), c.between(0.7, 1.2), 0.1, 640, 480}};
}
dmat4 at(const dvec3& place, const dvec3& half = dvec3(1)) {
    return glm::scale(glm::translate(dmat4(1), place), half);
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 4; ++i) {
        const Eye e = eye(c, i % 2 != 0);
        c.add("in front of the eye", e.to_world * at({c.between(-1, 1), c.between(-1, 1), -c.between(8, 12)}),
              e.camera);
    }
    c.group("edge");
    const Eye e = eye(c, true);
    c.add("rotated", e.to_world * at({0, 0, -c.between(8, 12)}) * c.rotation(), e.camera);
    c.add("partly off the screen",
          e.to_world * at({c.sign() * c.between(5, 6), 0, -8}, dvec3(2)) * c.rotation(), e.camera);
    c.add("off the screen", e.to_world * at({c.sign() * c.between(25, 30), 0, -8}), e.camera);
    c.add("all behind the eye", e.to_world * at({0, c.between(-1, 1), c.between(8, 12)}), e.camera);
    c.group("hard");
    const Eye f = eye(c, true);
    const double right = c.between(0.6, 1);
    c.add("a beam that passes to the right", f.to_world * at({right, 0, -6}, {0.2, 0.2, c.between(10, 14)}),
          f.camera);
    c.add("a beam that passes above and to the left",
          f.to_world * at({-right, right, -6}, {0.2, 0.2, c.between(10, 14)}), f.camera);
    c.add("a slanted beam",
          f.to_world * glm::rotate(at({-0.5, -0.8, -4}, {0.3, 0.1, c.between(8, 9)}), 0.1, dvec3(0, 1, 0)),
          f.camera);
    c.add("a floor under the eye", f.to_world * at({0, -c.between(1, 2), -4}, {3, 0.1, 9}), f.camera);
    c.add("a small cube at the eye", f.to_world * at({0.05, 0, 0}, dvec3(c.between(0.3, 0.5))), f.camera);
}
