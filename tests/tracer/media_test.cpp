// Light through glass and water.

#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

const double degree = std::numbers::pi / 180;

std::vector<const BoundaryChosen*> boundaries(const Trace& trace) {
    std::vector<const BoundaryChosen*> found;
    for (const TracedRay& ray : trace.rays)
        if (const auto* hit = ray.find<BoundaryChosen>()) found.push_back(hit);
    return found;
}
std::string medium(const Trace& trace, Id id) { return trace.media.at(std::size_t(id)).name; }

// A floor that glows, far below.
void add_floor(SceneBuilder& b) {
    b.generic(Plane<double>{}, translation({0, 0, -10}), b.glowing({1, 1, 1}), "floor");
}

TEST(Glass, a_slab_shifts_a_ray_and_keeps_its_direction) {
    for (const double index : {1.5, 1.0, 2.4, 0.9}) {
        SceneBuilder b;
        b.generic(Cube<double>{}, scaling(20, 20, 0.5), b.clear(0, 0.5, index), "slab");
        add_floor(b);
        const Vec3d d = normalized(Vec3d{1, 0, -1});
        const Trace trace = trace_ray(b.open(), {{-5, 0, 5}, d});
        ASSERT_EQ(trace.rays.size(), 3U) << index;
        EXPECT_EQ(trace.colour, Colour{0.25}); // the transmission of both its faces
        const RaySpawned& last = trace.rays[2].start();
        EXPECT_NEAR(length(last.direction - d), 0, 1e-15) << index;
        const double inside = std::asin(std::sin(45 * degree) / index);
        EXPECT_NEAR(last.origin.x, -0.5 + 1.0 * std::tan(inside), 1e-14) << index;
        if (index == 1) {
            EXPECT_EQ(last.direction, trace.rays[0].start().direction);
        } // bit for bit
    }
}

TEST(Glass, a_ray_that_starts_inside_knows_its_medium) {
    SceneBuilder b;
    b.generic(Sphere<double>{}, scaling(2), b.clear(0, 1, 1.5), "glass");
    add_floor(b);
    const Trace trace = trace_ray(b.open(), {{0, 0.5, 0}, {0, 0, -1}});
    ASSERT_EQ(trace.rays.size(), 2U);
    EXPECT_EQ(medium(trace, trace.rays[0].start().medium), "glass");
    EXPECT_EQ(medium(trace, trace.rays[1].start().medium), "air");
    const auto* hit = trace.rays[0].find<BoundaryChosen>();
    EXPECT_FALSE(hit->entering);
    EXPECT_DOUBLE_EQ(hit->speed_from, 1 / 1.5);
    EXPECT_EQ(hit->speed_to, 1);
    EXPECT_NEAR(trace.rays[0].find<Refracted>()->theta_to, std::asin(1.5 * 0.25), 1e-15);
}

struct GlassInWater : SceneBuilder {
    explicit GlassInWater(bool water_first) {
        for (const bool water : {water_first, !water_first}) {
            if (water)
                generic(Sphere<double>{}, scaling(3), clear(0, 1, 1.333), "water");
            else
                generic(Sphere<double>{}, Mat4d{1}, clear(0, 1, 1.5), "glass", 1);
        }
        add_floor(*this);
    }
};

TEST(Media, glass_in_water_bends_from_water) {
    for (const bool water_first : {true, false}) {
        GlassInWater b(water_first);
        const double offset = std::sqrt(0.5); // 45° on the glass, if nothing bent before
        const Trace trace = trace_ray(b.open(), {{0, offset, 2}, {0, 0, -1}}); // starts in the water
        const auto hits = boundaries(trace);
        ASSERT_EQ(hits.size(), 4U);
        EXPECT_EQ(medium(trace, trace.rays[0].start().medium), "water");
        const std::vector<std::pair<std::string, std::string>> expected{
            {"water", "glass"}, {"glass", "water"}, {"water", "air"}, {"air", "air"}};
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(medium(trace, hits[i]->medium_from), expected[i].first) << i;
            EXPECT_EQ(medium(trace, hits[i]->medium_to), expected[i].second) << i;
        }
        EXPECT_NEAR(trace.rays[0].find<Refracted>()->theta_to, std::asin(std::sin(45 * degree) * 1.333 / 1.5),
                    1e-14);
        EXPECT_NEAR(trace.rays[1].find<Refracted>()->theta_to, 45 * degree, 1e-14);
        EXPECT_NEAR(trace.rays[0].find<Refracted>()->eta, 1.333 / 1.5, 1e-15);
        EXPECT_EQ(trace.colour, Colour{1});
    }
}

TEST(Media, out_of_glass_into_water_at_45_degrees_there_is_no_total_reflection_but_by_the_notes_rule) {
    SceneBuilder b; // a cube of glass, its face towards the ray at 45°
    b.generic(Cube<double>{}, scaling(9), b.clear(0, 1, 1.333), "water");
    b.generic(Cube<double>{}, Mat4d{1}, b.clear(0, 1, 1.5), "glass");
    const Ray<double> ray{{0, 0, 0}, normalized(Vec3d{1, 1e-9, 1})};
    const Trace truth = trace_ray(b.open(), {{0.5, 0, 0}, ray.direction});
    ASSERT_NE(truth.rays[0].find<Refracted>(), nullptr);
    EXPECT_NEAR(truth.rays[0].find<Refracted>()->theta_to / degree, 52.72, 0.01);
    b.scene().notes_media = true;
    const Trace notes = trace_ray(b.open(), {{0.5, 0, 0}, ray.direction});
    ASSERT_NE(notes.rays[0].find<TotallyReflected>(), nullptr);
    EXPECT_EQ(medium(notes, notes.rays[0].find<BoundaryChosen>()->medium_to), "air");
}

TEST(Media, the_higher_priority_wins_and_among_equals_the_later_one) {
    const auto inside_of_both = [](int first, int second) {
        SceneBuilder b;
        b.generic(Cube<double>{}, Mat4d{1}, b.clear(0, 1, 1.2), "A", first);
        b.generic(Cube<double>{}, translation({1, 0, 0}), b.clear(0, 1, 1.7), "B", second);
        const Trace trace = trace_ray(b.open(), {{0.5, 0, 0}, {1, 0, 0}}); // leaves A at 1, B at 2
        std::vector<std::string> media;
        for (const auto* hit : boundaries(trace))
            media.push_back(medium(trace, hit->medium_from) + medium(trace, hit->medium_to));
        return media;
    };
    EXPECT_EQ(inside_of_both(0, 0), (std::vector<std::string>{"BB", "Bair"}));
    EXPECT_EQ(inside_of_both(1, 0), (std::vector<std::string>{"AB", "Bair"}));
    EXPECT_EQ(inside_of_both(0, 1), (std::vector<std::string>{"BB", "Bair"}));
    EXPECT_EQ(inside_of_both(-1, -2), (std::vector<std::string>{"AB", "Bair"}));
}

TEST(Media, an_opaque_stone_in_water_and_a_polygon_in_it_keep_the_water_around) {
    SceneBuilder b;
    b.generic(Sphere<double>{}, scaling(3), b.clear(0, 1, 1.333), "water");
    const auto pane = b.clear(0, 0.5, 1.7);
    b.generic(Polygon<double>({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}), Mat4d{1}, pane, "pane");
    const Trace trace = trace_ray(b.open(), {{0, 0, 2}, normalized(Vec3d{0, 0.1, -1})});
    const auto* hit = trace.rays[0].find<BoundaryChosen>();
    EXPECT_EQ(medium(trace, hit->medium_from), "water");
    EXPECT_EQ(medium(trace, hit->medium_to), "water");
    EXPECT_EQ(trace.rays[1].start().direction,
              trace.rays[0].start().direction); // a surface has no inside: nothing bends
}

// Two plates of glass face to face: the light passes the face that they share once, unbent, whichever comes first in
// the file, however they are turned.
TEST(Media, touching_plates_are_one_body) {
    for (const bool swapped : {false, true})
        for (std::uint64_t seed = 0; seed <= 50; ++seed) {
            Random random(seed);
            const Mat4d turn =
                seed == 0 ? Mat4d{1} : translation(random.in_cube(2)) * random_rotation(random);
            SceneBuilder b;
            for (const double z : {swapped ? 0.5 : -0.5, swapped ? -0.5 : 0.5})
                b.generic(Cube<double>{}, turn * translation({0, 0, z}) * scaling(9, 9, 0.5),
                          b.clear(0, 0.5, 1.5));
            b.generic(Plane<double>{}, turn * translation({0, 0, -10}), b.glowing({1, 1, 1}));
            const Vec3d d = transformed_vector(turn, normalized(Vec3d{0.5, 0.3, -1}));
            const Trace trace = trace_ray(b.open(), {transformed_point(turn, {0, 0, 4}), d});
            const std::string what = std::to_string(swapped) + " seed " + std::to_string(seed);
            ASSERT_EQ(trace.rays.size(), 4U) << what;
            ASSERT_EQ(trace.colour, Colour{0.125}) << what;
            ASSERT_EQ(trace.rays[1].find<Refracted>()->eta, 1) << what;
            ASSERT_NEAR(length(trace.rays[2].start().direction - trace.rays[1].start().direction), 0, 1e-15)
                << what;
            ASSERT_NEAR(length(trace.rays[3].start().direction - d), 0, 1e-14) << what;
            const auto* middle = trace.rays[1].find<BoundaryChosen>();
            ASSERT_NE(medium(trace, middle->medium_from), "air") << what;
            ASSERT_NE(medium(trace, middle->medium_to), "air") << what;
        }
}

TEST(TotalReflection, in_a_prism_one_ray_carries_both_shares) {
    SceneBuilder b;
    b.operand("block", Cube<double>{});
    b.operand("half", Plane<double>{}, rotation({0, 0, 1}, 45) * rotation({0, 1, 0}, 90)); // x + y ≤ 0
    b.compound("prism", "block & half", b.clear(0.06, 0.9, 1.5));
    b.scene().background = Colour{1};
    b.scene().limits.min_weight = 0.1;
    const Trace trace = trace_ray(b.open(), {{-6, -0.45, 0}, {1, 0, 0}});
    ASSERT_GE(trace.rays.size(), 3U);
    const TracedRay& within = trace.rays[1];
    const auto* total = within.find<TotallyReflected>();
    ASSERT_NE(total, nullptr);
    EXPECT_EQ(total->coefficient, Colour{0.06} + Colour{0.9});
    EXPECT_NEAR(total->theta_from, 45 * degree, 1e-15);
    EXPECT_NEAR(total->critical / degree, 41.810, 0.001);
    EXPECT_EQ(within.children.size(), 1U);
    EXPECT_EQ(within.find<Refracted>(), nullptr);
    const RaySpawned& turned = trace.rays[std::size_t(within.children[0])].start();
    EXPECT_EQ(turned.kind, RayKind::reflected);
    EXPECT_NEAR(length(turned.direction - Vec3d{0, -1, 0}), 0, 1e-15);
    EXPECT_NEAR(largest_component(turned.weight), 0.9 * 0.96, 1e-15);
}

TEST(TotalReflection, begins_at_the_critical_angle_of_water) {
    for (const double angle : {48.75, 48.76}) {
        SceneBuilder b;
        b.generic(Plane<double>{}, Mat4d{1}, b.clear(0, 1, 1 / 0.7519), "water");
        const double theta = angle * degree;
        const Trace trace = trace_ray(b.open(), {{0, 0, -1}, {std::sin(theta), 0, std::cos(theta)}});
        EXPECT_EQ(trace.rays[0].find<TotallyReflected>() != nullptr, angle > 48.755) << angle;
        EXPECT_EQ(trace.rays[0].find<Refracted>() != nullptr, angle < 48.755) << angle;
    }
}

} // namespace
} // namespace rayscope::test
