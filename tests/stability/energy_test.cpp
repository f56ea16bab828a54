// Guards against light that is made from nothing: by a coefficient counted twice, a ray followed twice, or a weight
// that grows.

#include "core/refraction/fresnel.hpp"
#include "tests/support/random.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// Everything around is white and nothing glows: what is not absorbed comes back, and no more.
Scene furnace(double reflection, double transmission, int depth) {
    SceneBuilder b;
    const std::size_t material = b.clear(reflection, transmission, 1.5);
    const std::size_t dense = b.clear(reflection, transmission, 2.4);
    b.generic(Sphere<double>{}, Mat4d{1}, material, "ball");
    b.generic(Sphere<double>{}, scaling(0.5, 0.5, 0.5), dense, "inner");
    b.generic(Torus<double>{}, translation({0.4, 0, 0.2}) * scaling(1.2, 1.2, 1.2), material, "ring");
    b.operand("block", Cube<double>{});
    b.operand("hole", Cylinder<double>{}, scaling(0.5, 0.5, 2));
    b.compound("drilled", "block - hole", dense, translation({2, 0.5, -1}));
    b.scene().background = Colour{1};
    b.scene().camera.eye = {0.3, 0.4, 6};
    b.scene().limits.max_depth = depth;
    b.scene().limits.min_weight = 0;
    b.scene().limits.max_rays = 3000;
    return b.scene();
}

Image image_of(const Scene& scene) {
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    return render(make_workbench(scene), options).image;
}

TEST(Energy, a_white_furnace_never_shines_brighter_than_white) {
    for (const double reflection : {0.0, 0.2, 0.5, 1.0})
        for (const int depth : {1, 4, 9}) {
            for (const float c : image_of(furnace(reflection, 1 - reflection, depth)).rgb)
                ASSERT_LE(c, 1 + 4 * epsilon<float>) << reflection << ' ' << depth;
        }
}

TEST(Energy, deeper_never_is_darker) {
    const auto shallow = image_of(furnace(0.3, 0.6, 2)), deep = image_of(furnace(0.3, 0.6, 8));
    for (std::size_t i = 0; i < deep.rgb.size(); ++i)
        ASSERT_GE(deep.rgb[i], shallow.rgb[i] * (1 - 4 * epsilon<float>));
}

// Guards against recursion without end: between perfect mirrors no weight falls.
TEST(Energy, light_between_perfect_mirrors_ends) {
    Scene scene = furnace(1, 0, 100000);
    for (const double distance : {3.0, -3.0}) {
        SceneGeneric wall;
        wall.shape = Cube<double>{};
        wall.matrix = translation({0, 0, 2 * distance}) * scaling(9, 9, 0.1);
        wall.material = 0;
        wall.visible = true;
        scene.generics.push_back(wall);
        scene.drawn.push_back({false, scene.generics.size() - 1});
    }
    scene.camera.eye = {0.1, 0.2, 5};
    for (const float c : image_of(scene).rgb) ASSERT_TRUE(c >= 0 && c <= 1 + 4 * epsilon<float>);
}

TEST(Energy, reflected_and_transmitted_shares_are_at_most_all) {
    Random random(12);
    for (int n = 0; n < 100000; ++n) {
        const double from = random.decade(-1, 1), to = random.decade(-1, 1);
        const Vec3d normal = random.direction(), direction = random.direction();
        const auto bent = refract<double>(direction, normal, from, to);
        const Reflectance<double> share = fresnel<double>(bent, from, to);
        for (const double part : {share.perpendicular, share.parallel, share.unpolarized()}) {
            ASSERT_GE(part, 0) << n;
            ASSERT_LE(part, 1) << n;
        }
        ASSERT_TRUE(!bent.total() || share.unpolarized() == 1) << n;
    }
}

} // namespace
} // namespace rayscope::test
