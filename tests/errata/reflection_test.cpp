// chapters/errata.md, what concerns reflection: the printed form fails, the right one holds.

#include "core/reflection/mirror.hpp"
#include "tests/errata/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

Vec3d printed_mirror(const Vec3d& hit_point, const Vec3d& n) { return hit_point - 2 * dot(hit_point, n) * n; }

TEST(Reflection, mirrored_point) {
    const Vec3d p{0, 1.5, 1}, d{0, 0.6, -0.8}, n{0, 0, 1}; // the plane z = 1, seen from (0, 0, 3)
    EXPECT_LT(dot(printed_mirror(p, n), n), 0) << "into the plane";
    EXPECT_EQ(mirrored<double>(d, n), Vec3d(0, 0.6, 0.8));

    const Trace trace = trace_ray(chapter_scene("03_reflection/mirror.toml"), {{0, 0, 3}, d});
    ASSERT_EQ(trace.rays.size(), 2U);
    EXPECT_LT(length(trace.rays[1].start().direction - Vec3d(0, 0.6, 0.8)), 1e-15);

    // From an eye at the origin the hit point is t d, and the printed form seems right.
    const Vec3d seen = normalized(printed_mirror(2.5 * d, n));
    EXPECT_LT(length(seen - Vec3d(0, 0.6, 0.8)), 1e-15);
}

// What a mirror adds to its local light is the fourth term; the fifth is 0 where nothing is transmitted.
TEST(Reflection, fourth_term) {
    const Trace trace = trace_ray(chapter_scene("03_reflection/mirror.toml"), {{0, 0, 3}, {0, 0.6, -0.8}});
    const TracedRay& first = trace.rays.front();
    const auto* end = first.find<RayFinished>();
    const Colour reflected = first.find<Reflected>()->coefficient * trace.rays[1].find<RayFinished>()->colour;
    EXPECT_EQ(trace.rays[1].start().kind, RayKind::reflected);
    EXPECT_GT(largest_component(reflected), 0.1);
    EXPECT_EQ(first.find<Refracted>(), nullptr) << "I_r = 0";
    EXPECT_EQ(end->colour, end->local + reflected) << "I = I_a + I_d + I_s + I_l";
}

/// How many rays are cast between facing mirrors, where every ray hits. As printed, the braces close before the colours
/// are added: neither k nor the coefficient guards the call.
int rays_as_printed(double coefficient, int k, int most) {
    if (most == 0) return 0;
    if (k > 0) {
        if (coefficient > 0) { /* compute l */
        }
    }
    return 1 + rays_as_printed(coefficient, k - 1, most - 1);
}
int rays_guarded(double coefficient, int k, int most) {
    if (most == 0) return 0;
    int rays = 1;
    if (k > 0)
        if (coefficient > 0) rays += rays_guarded(coefficient, k - 1, most - 1);
    return rays;
}

TEST(Reflection, braces) {
    EXPECT_EQ(rays_as_printed(0.9, 3, 1000), 1000) << "level 3 stops nothing";
    EXPECT_EQ(rays_as_printed(0, 3, 1000), 1000) << "nor does a surface that reflects nothing";
    EXPECT_EQ(rays_guarded(0.9, 3, 1000), 4);
    EXPECT_EQ(rays_guarded(0, 3, 1000), 1);

    Workbench bench = chapter_scene("03_reflection/facing_mirrors.toml");
    bench.world.max_depth = 3;
    EXPECT_EQ(trace_ray(bench, {{0, 0, 0}, {1, 0, 0}}).rays.size(), 4U);
}

TEST(Reflection, threshold) {
    Workbench bench = chapter_scene("03_reflection/facing_mirrors.toml");
    bench.world.max_depth = 250;
    bench.world.min_weight = 0.001;
    const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(trace_ray(bench, ray).rays.size(), 66U) << "0.9^66 < 0.001: the threshold ends it";
    for (Material& material : bench.world.materials) material.reflection = Colour{1};
    const Trace endless = trace_ray(bench, ray);
    EXPECT_EQ(endless.rays.size(), 251U) << "only the depth ended it";
    EXPECT_EQ(weight(endless.rays.back()), 1);
    EXPECT_EQ(endless.rays.back().find<NotSpawned>()->reason, Reason::depth);
}

// The room between the mirrors is closed and grey; the background is blue and can't be seen.
TEST(Reflection, cut_is_not_background) {
    Workbench bench = chapter_scene("03_reflection/facing_mirrors.toml");
    bench.world.max_depth = 3;
    const Trace trace = trace_ray(bench, {{0, 0, 0}, {1, 0, 0}});
    EXPECT_NEAR(trace.colour.z, 1 - std::pow(0.9, 4), 1e-15);
    EXPECT_EQ(trace.colour.x, trace.colour.z) << "grey";
    const Colour filled = trace.colour + std::pow(0.9, 4) * bench.world.background;
    EXPECT_GT(filled.z - filled.x, 0.39) << "blue light from nowhere";
}

} // namespace
} // namespace rayscope::test
