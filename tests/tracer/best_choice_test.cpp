// Which stages an image is made with, where nobody says.

#include "core/scene/build.hpp"
#include "core/tracer/stage_set.hpp"
#include "tests/support/scenes.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;
using testing::Not;

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

// A light's lists are made for its middle: rays to its area go through boxes, also where nothing mirrors.
TEST(BestChoice, walks_through_boxes_to_lights_with_an_area) {
    SceneBuilder b;
    SceneLight& lamp = b.light({0, 0, 10});
    lamp.area.shape = LightArea::Shape::sphere;
    lamp.area.radius = 1;
    lamp.area.samples = 4;
    const std::size_t material = b.clear(0, 0, 1);
    for (int i = 0; i < 100; ++i) b.generic(Torus<double>{}, translation(Vec3d{3.0 * i, 0, 0}), material);
    const BestChoice area = best_choice(build(b.scene()));
    EXPECT_EQ(area.choice.shadow, StageKind::bvh);
    EXPECT_THAT(area.reason, HasSubstr("shadow rays to areas walk through boxes"));
    EXPECT_THAT(area.reason, Not(HasSubstr("each light lists")));
    b.light({0, 5, 10});
    const BestChoice both = best_choice(build(b.scene()));
    EXPECT_EQ(both.choice.shadow, StageKind::light);
    EXPECT_EQ(both.choice.other, StageKind::bvh) << "where rays to areas go";
    EXPECT_THAT(both.reason, HasSubstr("shadow rays to areas walk through boxes"));
}

TEST(BestChoice, names_how_many_no_box_would_hold) {
    SceneBuilder b;
    const std::size_t material = b.clear(0, 0, 1);
    for (int i = 0; i < 100; ++i) b.generic(Torus<double>{}, translation(Vec3d{3.0 * i, 0, 0}), material);
    const Mat4d pressed = scaling(1, 1, 1e-9) * rotation({0, 1, 0}, 30);
    b.generic(Torus<double>{}, pressed, material);
    EXPECT_THAT(best_choice(build(b.scene())).reason, HasSubstr("; 1 object is so distorted or lies so far"));
}

TEST(StageChoice, limits_an_octree) {
    const StageChoice notes = stage_choice("octree,capacity=1,least_size=0.01");
    EXPECT_EQ(notes.eye, StageKind::octree);
    EXPECT_EQ(notes.octree, (OctreeLimits{.depth = 0, .capacity = 1, .least_size = 0.01}));
    EXPECT_EQ(stage_choice("eye=projective,depth=7,other=octree").octree.depth, 7);
    const auto error = [](const char* text) {
        try {
            (void)stage_choice(text);
            return std::string("none");
        } catch (const std::invalid_argument& problem) {
            return std::string(problem.what());
        }
    };
    EXPECT_EQ(error("octree,eye=scan"),
              "expected capacity=, depth= or least_size= after 'octree', found 'eye=scan'");
    EXPECT_EQ(error("octree,capacity=0"),
              "expected a number of objects from 1 to 1000000 after 'capacity=', found '0'");
    EXPECT_EQ(error("octree,depth=99"),
              "expected a number of levels from 1 to 24 after 'depth=', found '99'");
    EXPECT_EQ(error("octree,least_size=nan"),
              "expected a share of the whole's edge, above 0 and up to 1 after 'least_size=', found 'nan'");
    EXPECT_EQ(error("bvh,capacity=2"), "'bvh,capacity=2' limits an octree, but no rays are found by one");
    EXPECT_EQ(error("eye=projective,bvh"),
              "expected eye=, shadow=, other= or, of an octree, capacity=, depth= or "
              "least_size=, found 'bvh'");
    EXPECT_EQ(error("eye=scan,capacity"), "expected a value after 'capacity='");
    EXPECT_EQ(error("eye=scan,eye=bvh"), "'eye=' stands there twice");
    for (const char* wrong : {"", "octree,", "eye=scan,,", "eye=scan,capacity", ","})
        EXPECT_NE(error(wrong), "none") << wrong;
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
