// Why a ray went by: cells that it did not look into, solids that it missed.

#include "tests/support/temporary_folder.hpp"

#include "core/octree/why_not_cell.hpp"
#include "core/rayscope.hpp"

#include <gmock/gmock.h>

#include <set>

namespace rayscope::test {
namespace {

// 4 × 4 × 4 balls that do not touch, every other one of glass.
std::string many_balls() {
    std::string text =
        "[camera]\neye = [0, 0, 12]\nlook_at = [0, 0, 0]\n[lights.lamp]\nposition = [5, 9, 9]\n"
        "[materials.grey]\n[materials.glass]\nreflection = 0.2\ntransmission = 0.7\nindex = 1.5\n";
    for (int i = 0; i < 64; ++i) {
        const auto at = [](int k) { return std::to_string(1.4 * k - 2.1 + 0.013 * ((k * 7) % 5)); };
        text += "[generics.ball_" + std::to_string(i) + "]\nshape = \"sphere\"\nmaterial = \"" +
                (i % 2 == 0 ? "grey" : "glass") + "\"\ntransform = [{scale = 0.55}, {translate = [" +
                at(i % 4) + ", " + at(i / 4 % 4) + ", " + at(i / 16) + "]}]\n";
    }
    return text;
}

TEST(WhyNotCell, says_of_each_cell_what_the_walk_did) {
    using Why = WhyNotCell::Reason;
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "balls.toml") << many_balls();
    const Workbench bench = open(folder.path() / "balls.toml");
    const auto stages = make_stages(bench, stage_choice("octree"));
    std::map<Why, int> reasons;
    for (const int pixel : {100, 200, 256, 300, 333, 400}) {
        const Trace trace = trace_pixel(bench, *stages, pixel, 512 - pixel);
        for (std::size_t ray = 0; ray < trace.rays.size(); ++ray) {
            std::set<Id> visited;
            for (const Event& event : trace.rays[ray].events)
                if (const auto* place = std::get_if<PlaceEntered>(&event);
                    place && place->kind == PlaceKind::cell)
                    visited.insert(place->place);
            const bool shadow = trace.rays[ray].start().kind == RayKind::shadow; // which may end early
            for (std::uint32_t cell = 0;; ++cell) {
                const auto why = why_not_cell(*stages, trace, ray, cell);
                if (!why) {
                    EXPECT_GE(cell, 8U);
                    break;
                }
                ++reasons[why->reason];
                const bool looked = why->reason == Why::looked_into;
                if (shadow && !visited.contains(Id(cell))) continue;
                EXPECT_EQ(looked, visited.contains(Id(cell))) << "ray " << ray << ", cell " << cell;
            }
        }
    }
    for (const Why why :
         {Why::box_missed, Why::contents_missed, Why::behind, Why::beyond_reach, Why::looked_into})
        EXPECT_GT(reasons[why], 0) << int(why);
}

TEST(Passing, is_the_distance_to_a_sphere) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/glass_bowl.toml");
    Scene scene = bench.scene;
    const auto sphere = std::ranges::find_if(scene.generics, [](const SceneGeneric& generic) {
        return std::holds_alternative<Sphere<double>>(generic.shape);
    });
    ASSERT_NE(sphere, scene.generics.end());
    sphere->matrix = glm::dmat4(2);   // a ball of radius 1 at twice its size …
    sphere->matrix[3] = {1, 2, 3, 1}; // … around (1, 2, 3)
    scene.drawn = {{false, std::size_t(sphere - scene.generics.begin())}};
    for (const double far : {2.5, 5.0, 60.0}) {
        const auto all = passings(scene, 0, {{1 + far, 2, -7}, {0, 0, 4}}, 3);
        ASSERT_EQ(all.size(), 1U);
        EXPECT_NEAR(all[0].t, 2.5, 1e-6);
        EXPECT_NEAR(all[0].outside, far / 2 - 1, 1e-9);
    }
    EXPECT_LT(passings(scene, 0, {{1.1, 2, -7}, {0, 0, 4}}, 3)[0].outside, 0);
}

TEST(RefractionCard, has_the_numbers_of_the_events) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml");
    const Trace trace = trace_pixel(bench, 240, 240);
    const auto entry = refraction_card(trace, 0), total = refraction_card(trace, 4);
    ASSERT_TRUE(entry && total);
    EXPECT_FALSE(entry->critical);
    EXPECT_EQ(entry->theta_to, trace.rays[0].find<Refracted>()->theta_to);
    // Into glass of n = 1.5: 4 % by the normal.
    EXPECT_NEAR(entry->fresnel, 0.04, 0.001);
    EXPECT_NEAR(entry->schlick, 0.04, 0.001);
    EXPECT_NEAR(entry->fresnel, (entry->fresnel_s + entry->fresnel_p) / 2, 1e-15);
    EXPECT_TRUE(total->total());
    EXPECT_EQ(total->fresnel, 1);
    EXPECT_NEAR(*total->beyond_critical(), total->theta_from - std::asin(1 / 1.5), 1e-12);
    EXPECT_FALSE(refraction_card(trace, 1)); // a shadow ray
}

} // namespace
} // namespace rayscope::test
