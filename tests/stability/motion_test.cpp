// Guards against answers that depend on where the origin of the world is, how its axes lie, and how long its unit is.

#include "tests/stability/draw_case.hpp"
#include "tests/stability/moved.hpp"
#include "tests/stability/property.hpp"
#include "tests/support/scenes.hpp"

namespace rayscope::test {
namespace {

// Some solids, plain and in compounds, glass, mirrors and dull ones, on a floor under two lights.
Scene draw_scene(Random& random) {
    SceneBuilder b;
    SceneMaterial dull = SceneBuilder::dark();
    dull.diffuse = Colour{0.5};
    dull.ambient = Colour{0.1};
    const std::array materials{b.material(dull), b.clear(0.3, 0.6, random.uniform(1, 2)), b.clear(0.9, 0, 1)};
    const auto any_material = [&] { return materials[std::size_t(random.below(3))]; };
    const auto shapes = solid_generics();
    const auto any_shape = [&] { return shapes[std::size_t(random.below(int(shapes.size())))]; };
    b.generic(Plane<double>{}, translation({0, -4, 0}) * rotation({1, 0, 0}, -90), materials[0], "floor");
    for (int i = 0; i < 4; ++i) {
        Generic<double> shape = any_shape();
        if (std::holds_alternative<Plane<double>>(shape)) shape = Cube<double>{};
        b.generic(shape, random_matrix(random), any_material(), {char('p' + i)});
    }
    for (char name = 'a'; name <= 'f'; ++name) b.operand({name}, any_shape(), random_matrix(random));
    b.compound("one", "a - b | c", any_material(), random_rotation(random));
    b.compound("two", "d & (e - f)", any_material());
    b.light(random.in_cube(8));
    b.sun(random.direction());
    b.scene().camera.eye = 12.0 * random.direction();
    b.scene().camera.up = random.direction();
    b.scene().limits.max_depth = 4;
    return b.scene();
}

Motion draw_motion(Random& random) {
    Motion motion;
    const int kind = random.below(5); // one of them, or all at once
    if (kind == 0 || kind == 4) motion.matrix = random_rotation(random);
    if (kind == 1 || kind == 4) {
        motion.mirrored = true;
        motion.matrix = motion.matrix * scaling(1, 1, -1);
    }
    if (kind == 2 || kind == 4) {
        motion.scale = random.decade(-6, 6);
        motion.matrix = scaling(motion.scale) * motion.matrix;
    }
    if (kind == 3 || kind == 4)
        motion.matrix = translation(motion.scale * random.in_cube(random.decade(0, 4))) * motion.matrix;
    return motion;
}

constexpr int picture_side = 32;

void expect_unmoved(int scenes) {
    int rays = 0, parted = 0;
    expect_property("moved", scenes, [&] {
        const auto seed =
            *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
        Random random(seed);
        const Scene scene = draw_scene(random);
        const Motion motion = draw_motion(random);
        const Workbench here = make_workbench(scene), there = make_workbench(moved(scene, motion));
        const EyeRays eye(here.scene.camera, picture_side, picture_side),
            moved_eye(there.scene.camera, picture_side, picture_side);
        Comparison comparison(here.world, there.world, motion);
        for (int i = 0; i < 40; ++i) {
            const int x = random.below(picture_side), y = random.below(picture_side);
            // In a mirror the camera's right is left.
            const double moved_x = motion.mirrored ? picture_side - x - 0.5 : x + 0.5;
            const Agreement agreement =
                comparison.compare(eye.through(x + 0.5, y + 0.5), moved_eye.through(moved_x, y + 0.5));
            rays += agreement.rays;
            parted += agreement.parted;
            if (!agreement.wrong.empty())
                RC_FAIL(agreement.wrong + "\nscene of seed " + std::to_string(seed) + " by " +
                        hex(motion.matrix));
        }
    });
    EXPECT_LE(parted, rays / 100) << "of " << rays;
    EXPECT_GE(rays, scenes * 40);
}

TEST(Motion, of_a_whole_scene_moves_hits_within_their_bounds_only) { expect_unmoved(samples(200)); }
TEST(MotionFull, of_a_whole_scene_moves_hits_within_their_bounds_only) { expect_unmoved(samples(20000)); }

} // namespace
} // namespace rayscope::test
