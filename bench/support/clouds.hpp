#pragma once
// Random balls in [−1, 1]³: as many as one likes, in a scene that looks alike with any number.

#include "bench/support/easy_rays.hpp"
#include "core/scene/scene.hpp"

#include <cmath>
#include <numbers>

namespace rayscope::bench {

/// A radius with which `count` balls cover a face of the cube `layers` times over, however many they are.
[[nodiscard]] inline double covering_radius(std::size_t count, double layers) {
    return std::sqrt(4 * layers / (std::numbers::pi * double(count)));
}

/// A radius with which they fill the same share of the volume: half the mean distance of their centres, cubed.
[[nodiscard]] inline double filling_radius(std::size_t count) { return 0.5 / std::cbrt(double(count)); }

[[nodiscard]] inline Scene cloud(std::size_t count, double radius) {
    Random random;
    Scene scene;
    scene.file = "cloud";
    scene.background = Colour{0.3, 0.4, 0.6};
    scene.limits = {4, 0};
    SceneMaterial& material = scene.materials.emplace_back();
    material.reflection = Colour{0.2};
    scene.lights.push_back({"lamp", false, {4, 6, 5}, Colour{1}, true, {}, {}});
    scene.camera.eye = normalized(Vec3d{0.3, 0.5, 1}) * 4.5;
    scene.camera.field_of_view = 36;
    scene.generics.reserve(count);
    scene.drawn.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        SceneGeneric& ball = scene.generics.emplace_back();
        ball.shape = Sphere<double>{radius};
        ball.matrix[3] = {random.point(), 1};
        ball.material = 0;
        scene.drawn.push_back({false, i});
    }
    return scene;
}

} // namespace rayscope::bench
