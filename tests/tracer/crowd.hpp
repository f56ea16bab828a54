#pragma once
// A scene with enough in it that a stage has something to save.

#include "tests/support/random.hpp"
#include "tests/support/scenes.hpp"

namespace rayscope::test {

/// A cloud of balls, some of them mirrors, and a floor without end.
[[nodiscard]] inline Scene crowd() {
    SceneBuilder b;
    Random random(7);
    SceneMaterial mirror;
    mirror.diffuse = Colour{0.4};
    mirror.reflection = Colour{0.5};
    SceneMaterial matte;
    matte.diffuse = Colour{0.7};
    const std::size_t shiny = b.material(mirror), plain = b.material(matte);
    for (int i = 0; i < 60; ++i)
        b.generic(Sphere<double>{}, translation(random.in_cube(3.0)) * scaling(random.uniform(0.1, 0.4)),
                  i % 3 == 0 ? shiny : plain);
    b.generic(Plane<double>{}, translation({0, 0, -4}), plain);
    b.light({4, 5, 6});
    Scene scene = b.scene();
    scene.camera.eye = {0, -9, 1};
    scene.camera.width = 64;
    scene.camera.height = 48;
    return scene;
}

} // namespace rayscope::test
