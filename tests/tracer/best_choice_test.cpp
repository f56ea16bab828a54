// Which stages an image is made with, where nobody says.

#include "core/scene/build.hpp"
#include "core/tracer/stage_set.hpp"
#include "tests/support/scenes.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;

Generic<double> triangle() { return Polygon<double>({Vec3d{0, 0, 0}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}}); }

BestChoice choice_for(const Generic<double>& shape, int count, double reflection = 0.5, bool shadows = true) {
    SceneBuilder b;
    b.light({0, 0, 10}).shadows = shadows;
    const std::size_t material = b.clear(reflection, 0, 1);
    for (int i = 0; i < count; ++i)
        b.generic(shape, translation(Vec3d{3.0 * i, 0, 0}), material, "g" + std::to_string(i));
    return best_choice(build(b.scene()));
}

TEST(BestChoice, tests_a_few_objects_one_by_one) {
    EXPECT_EQ(choice_for(Sphere<double>{}, 12).choice.eye, StageKind::scan);
    EXPECT_THAT(choice_for(Sphere<double>{}, 1).reason, HasSubstr("1 object:"));
}

TEST(BestChoice, looks_for_a_few_dear_ones) {
    const BestChoice best = choice_for(Torus<double>{}, 4);
    EXPECT_EQ(best.choice.eye, StageKind::projective);
    EXPECT_THAT(best.reason, HasSubstr("4 objects, as dear to test as 120 balls"));
}

TEST(BestChoice, keeps_lists_of_solids_and_boxes_of_polygons) {
    const StageChoice solids = choice_for(Torus<double>{}, 100).choice;
    EXPECT_EQ(solids.eye, StageKind::projective);
    EXPECT_EQ(solids.shadow, StageKind::light);
    EXPECT_EQ(solids.other, StageKind::bvh);
    const BestChoice polygons = choice_for(triangle(), 100);
    EXPECT_EQ(polygons.choice.eye, StageKind::bvh);
    EXPECT_EQ(polygons.choice.shadow, StageKind::bvh);
    EXPECT_THAT(polygons.reason, HasSubstr("mostly polygons"));
}

TEST(BestChoice, builds_nothing_for_rays_that_there_are_none_of) {
    const BestChoice matte = choice_for(Torus<double>{}, 100, 0);
    EXPECT_EQ(matte.choice.shadow, StageKind::light);
    EXPECT_EQ(matte.choice.other, StageKind::scan);
    EXPECT_THAT(matte.reason, HasSubstr("nothing mirrors or refracts"));
    const BestChoice unshadowed = choice_for(Torus<double>{}, 100, 0.5, false);
    EXPECT_EQ(unshadowed.choice.shadow, StageKind::scan);
    EXPECT_EQ(unshadowed.choice.other, StageKind::bvh);
    EXPECT_THAT(unshadowed.reason, HasSubstr("no light casts shadows"));
}

TEST(BestChoice, looks_into_a_single_compound_with_parts_apart) {
    SceneBuilder b;
    const std::size_t material = b.clear(0, 0, 1);
    std::string expression;
    for (int i = 0; i < 30; ++i) {
        const std::string name = "ring" + std::to_string(i);
        b.operand(name, Torus<double>{}, translation(Vec3d{3.0 * i, 0, 0}));
        expression += (i > 0 ? " | " : "") + name;
    }
    b.compound("chain", expression, material);
    const BestChoice best = best_choice(build(b.scene()));
    EXPECT_NE(best.choice.eye, StageKind::scan);
    EXPECT_THAT(best.reason, HasSubstr("parts of a compound"));
}

} // namespace
} // namespace rayscope::test
