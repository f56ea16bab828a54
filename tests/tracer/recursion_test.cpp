// How far the recursion goes, and how shares add up.

#include "core/extents/scan.hpp"
#include "core/tracer/tracer.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// Two mirrors face to face, at z = −1 and z = 1; each glows a little.
struct Mirrors : SceneBuilder {
    Mirrors(double ambient, double reflection) {
        SceneMaterial m = dark();
        m.ambient = Colour{ambient};
        m.reflection = Colour{reflection};
        const auto mirror = material(m);
        generic(Plane<double>{}, translation({0, 0, -1}), mirror, "below");
        generic(Plane<double>{}, translation({0, 0, 1}) * rotation({1, 0, 0}, 180), mirror, "above");
        scene().background = Colour{1000};
        scene().limits.min_weight = 0;
    }
    [[nodiscard]] Trace trace() const { return trace_ray(open(), {{0, 0, 0}, {0, 0, -1}}); }
    [[nodiscard]] double seen() const { return trace().colour.x; }
};

const NotSpawned* last_refusal(const Trace& trace, RayKind kind) {
    const NotSpawned* found = nullptr;
    for (const TracedRay& ray : trace.rays)
        for (const Event& event : ray.events)
            if (const auto* refused = std::get_if<NotSpawned>(&event);
                refused != nullptr && refused->kind == kind)
                found = refused;
    return found;
}

TEST(Recursion, two_mirrors_give_a_geometric_series) {
    Mirrors b(1, 0.5);
    for (int depth = 0; depth < 10; ++depth) {
        b.scene().limits.max_depth = depth;
        EXPECT_EQ(b.seen(), 2 - std::ldexp(1.0, -depth)) << depth; // and no background where it is cut
    }
    b.scene().limits.max_depth = 3;
    const Trace trace = b.trace();
    ASSERT_EQ(trace.rays.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(trace.rays[i].start().depth, int(i));
        EXPECT_EQ(weight(trace.rays[i]), std::ldexp(1.0, -int(i)));
        EXPECT_EQ(trace.rays[i].parent, int(i) - 1);
    }
    ASSERT_NE(last_refusal(trace, RayKind::reflected), nullptr);
    EXPECT_EQ(last_refusal(trace, RayKind::reflected)->reason, Reason::depth);
    EXPECT_EQ(last_refusal(trace, RayKind::refracted)->reason, Reason::coefficient_zero);
}

TEST(Recursion, ends_below_the_least_weight_and_not_at_it) {
    Mirrors b(1, 0.5);
    b.scene().limits.max_depth = 100;
    b.scene().limits.min_weight = 0.2;
    EXPECT_EQ(b.seen(), 1.75);
    EXPECT_EQ(last_refusal(b.trace(), RayKind::reflected)->reason, Reason::weight);
    EXPECT_EQ(last_refusal(b.trace(), RayKind::reflected)->weight, Colour{0.125});
    b.scene().limits.min_weight = 0.25;
    EXPECT_EQ(b.seen(), 1.75);
    b.scene().limits.min_weight = std::nextafter(0.25, 1);
    EXPECT_EQ(b.seen(), 1.5);
    b.scene().limits.min_weight = 0;
    EXPECT_NEAR(b.seen(), 2, 1e-15);
    EXPECT_EQ(b.trace().rays.size(), 101U);
}

TEST(Recursion, the_weight_is_the_largest_component_of_the_product) {
    Mirrors b(1, 0.5);
    b.scene().materials[0].reflection = {0.1, 0.5, 0.01};
    b.scene().limits.max_depth = 2;
    b.scene().limits.min_weight = 0.25;
    const Trace trace = b.trace();
    ASSERT_EQ(trace.rays.size(), 3U);
    EXPECT_EQ(weight(trace.rays[2]), 0.25);
    EXPECT_NEAR(trace.colour.x, 1.11, 1e-15);
    EXPECT_EQ(trace.colour.y, 1.75);
    EXPECT_NEAR(trace.colour.z, 1.0101, 1e-15);
}

TEST(Recursion, perfect_mirrors_end_at_the_depth_and_256_levels_fit_the_stack) {
    Mirrors b(1, 1);
    b.scene().limits.max_depth = 256;
    EXPECT_EQ(b.seen(), 257);
    EXPECT_EQ(b.trace().rays.size(), 257U);
}

TEST(Recursion, the_limit_on_rays_ends_it_too) {
    Mirrors b(1, 0.5);
    b.scene().limits.max_depth = 50;
    b.scene().limits.max_rays = 2;
    EXPECT_EQ(b.seen(), 1.75);
    EXPECT_EQ(last_refusal(b.trace(), RayKind::reflected)->reason, Reason::ray_limit);
    b.scene().camera.eye = {0, 0, 0};
    b.scene().camera.look_at = {0, 0, -1};
    RenderOptions options;
    options.width = options.height = 1;
    const RenderResult result = render(b.open(), options);
    EXPECT_EQ(result.statistics.counters.cut_by_ray_limit, 1U);
    EXPECT_EQ(result.statistics.counters.rays, (std::array<std::uint64_t, 4>{1, 2, 0, 0}));
}

TEST(Recursion, a_miss_adds_the_background) {
    SceneBuilder b;
    b.scene().background = {0.1, 0.2, 0.3};
    b.generic(Sphere<double>{}, Mat4d{1}, b.clear(0.5, 0, 1));
    const Workbench bench = b.open();
    EXPECT_EQ(trace_ray(bench, {{0, 0, 5}, {0, 0, 1}}).colour, (Colour{0.1, 0.2, 0.3}));
    EXPECT_EQ(trace_ray(bench, {{0, 0, 5}, {0, 0, -1}}).colour, (Colour{0.05, 0.1, 0.15}));
}

TEST(Recursion, equal_t_goes_to_the_first_in_the_file) {
    for (const bool swapped : {false, true}) {
        SceneBuilder b;
        const auto red = b.glowing({1, 0, 0}), blue = b.glowing({0, 0, 1});
        b.generic(Cube<double>{}, Mat4d{1}, swapped ? blue : red);
        b.generic(Cube<double>{}, translation({0.5, 0, 0}), swapped ? red : blue);
        EXPECT_EQ(trace_ray(b.open(), {{0.25, 0, 5}, {0, 0, -1}}).colour,
                  (swapped ? Colour{0, 0, 1} : Colour{1, 0, 0}));
        SceneBuilder balls; // a ball is found by another loop than the cube
        const auto first = balls.glowing({1, 0, 0}), second = balls.glowing({0, 0, 1});
        if (swapped) balls.generic(Cube<double>{}, Mat4d{1}, first);
        balls.generic(Sphere<double>{}, Mat4d{1}, swapped ? second : first);
        if (!swapped) balls.generic(Cube<double>{}, Mat4d{1}, second);
        EXPECT_EQ(trace_ray(balls.open(), {{0, 0, 5}, {0, 0, -1}}).colour, (Colour{1, 0, 0}));
    }
}

TEST(Recursion, a_cap_on_events_cuts_the_record_and_not_the_light) {
    Mirrors b(1, 0.5);
    b.scene().limits.max_depth = 20;
    const Workbench bench = b.open();
    const Scan<double> stage(bench.world);
    const Ray<double> ray{{0, 0, 0}, {0, 0, -1}};
    for (const std::size_t cap : {0U, 1U, 7U, 50U, 100000U}) {
        Work<double> work;
        TraceRecorder recorder(cap);
        Tracer tracer(bench.world, stage, work, recorder);
        EXPECT_EQ(tracer.trace(ray), b.trace().colour);
        EXPECT_EQ(recorder.dropped() > 0, cap < 100000) << cap;
        for (const TracedRay& traced : recorder.take()) {
            ASSERT_FALSE(traced.events.empty()) << cap;
            EXPECT_TRUE(std::holds_alternative<RaySpawned>(traced.events.front())) << cap;
            EXPECT_TRUE(std::holds_alternative<RayFinished>(traced.events.back())) << cap;
        }
    }
}

} // namespace
} // namespace rayscope::test
