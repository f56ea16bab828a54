// chapters/errata.md, what concerns extents and the octree: the printed form fails, the right one holds.

#include "core/reflection/mirror.hpp"
#include "core/scene/read_toml.hpp"
#include "tests/errata/scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rayscope::test {
namespace {

bool in_generic_cube(const Box<double>& box) {
    return largest_component(absolute(box.low)) <= 1 && largest_component(absolute(box.high)) <= 1;
}

TEST(Extents, generic_cube) {
    EXPECT_TRUE(in_generic_cube(Sphere<double>{}.bounds()));
    EXPECT_TRUE(in_generic_cube(Cylinder<double>{}.bounds()));
    EXPECT_TRUE(in_generic_cube(Cone<double>{}.bounds()));
    EXPECT_FALSE(in_generic_cube(Plane<double>{}.bounds())) << "endless";
    EXPECT_FALSE(in_generic_cube(Torus<double>{}.bounds()));
    // A ray that misses the cube and meets the ring.
    const Ray<double> beside{{1.1, 0, 5}, {0, 0, -1}};
    EXPECT_EQ(Cube<double>{}.intervals(beside).count, 0);
    EXPECT_EQ(Torus<double>{}.intervals(beside).count, 1);
}

// An extent saves its object's test where it is missed, and is paid for always: it pays only if it costs less than the
// share of rays that miss it times the object. For each object its own box: as many tests as before, and more.
TEST(Extents, cheaper_cube) {
    const Workbench crowd = chapter_scene("05_extents/crowd.toml");
    RenderOptions options;
    options.width = 64;
    options.height = 48;
    const auto tests = [&](const char* stage) {
        options.stage = stage_choice(stage);
        const Counters counters = render(crowd, options).statistics.counters;
        std::uint64_t generics = 0;
        for (const std::uint64_t count : counters.tests) generics += count;
        return std::pair(generics, counters.boxes);
    };
    const auto [scanned, no_boxes] = tests("scan");
    const auto [left, boxes] = tests("extents");
    EXPECT_EQ(no_boxes, 0U);
    EXPECT_LT(left, scanned / 10) << "hardly any object is left to test";
    EXPECT_GT(double(left + boxes), 0.95 * double(scanned)) << "and yet about as many tests are made";
}

struct Slope { // of a point seen from the origin along −z
    double x, y;
};
Slope projected(const Vec3d& p) { return {p.x / -p.z, p.y / -p.z}; }

struct Rectangle {
    Slope low{1e9, 1e9}, high{-1e9, -1e9};
    void include(const Slope& s) {
        low = {std::min(low.x, s.x), std::min(low.y, s.y)};
        high = {std::max(high.x, s.x), std::max(high.y, s.y)};
    }
    [[nodiscard]] bool contains(const Slope& s) const {
        return low.x <= s.x && s.x <= high.x && low.y <= s.y && s.y <= high.y;
    }
};

// A box beside the eye that reaches from before it to behind it.
TEST(Extents, projected_corners) {
    const Vec3d low{1, 1, -4}, high{2, 2, 1};
    Rectangle printed, clipped;
    constexpr double near_plane = 0.1;
    for (int i = 0; i < 4; ++i) {
        const double x = (i & 1) != 0 ? high.x : low.x, y = (i & 2) != 0 ? high.y : low.y;
        printed.include(projected({x, y, low.z}));
        printed.include(projected({x, y, high.z})); // behind the eye: lands on the other side
        clipped.include(projected({x, y, low.z}));
        clipped.include(projected({x, y, -near_plane})); // where the edge meets the near plane
    }
    for (const double z : {-2.0, -1.0, -0.5}) {
        const Slope seen = projected({1.5, 1.5, z}); // in the box and before the eye
        EXPECT_FALSE(printed.contains(seen)) << z;
        EXPECT_TRUE(clipped.contains(seen)) << z;
    }

    Scene scene = parse_toml("[camera]\neye = [0, 0, 0]\nlook_at = [0, 0, -1]\nfield_of_view = 90\n"
                             "[materials.m]\n[generics.box]\nshape = 'cube'\nmaterial = 'm'\n"
                             "transform = [{ scale = [0.5, 0.5, 2.5] }, { translate = [1.5, 1.5, -1.5] }]\n",
                             "box.toml");
    const Workbench bench = make_workbench(std::move(scene));
    const ScreenExtents screen = screen_extents(bench);
    ASSERT_EQ(screen.rectangles.size(), 1U);
    EXPECT_EQ(screen.rectangles[0].right, screen.width) << "what reaches the eye is listed everywhere";
}

Vec3d perspective(const Vec3d& p) {
    return {p.x / -p.z, p.y / -p.z, 1 + 1 / p.z};
} // depth 0 at z = −1, 1 far away

TEST(Extents, projective_octree) {
    // A mirrored ray that comes from behind the eye: the order of its points is another one after the projection.
    const Ray<double> ray{{1, 0, 2}, {0, 0.1, -1}};
    const auto depth_at = [&](double t) { return perspective(ray.at(t)).z; };
    const std::array<double, 4> by_t{1, 1.9, 2.1, 4}; // it passes the eye's plane at t = 2
    EXPECT_LT(ray.at(1.9).z * ray.at(2.1).z, 0);
    std::array<double, 4> depths{};
    std::transform(by_t.begin(), by_t.end(), depths.begin(), depth_at);
    EXPECT_FALSE(std::is_sorted(depths.begin(), depths.end()));
    EXPECT_FALSE(std::is_sorted(depths.rbegin(), depths.rend()));

    // A floor, and a ray that it mirrors: mirrored in the world, not mirrored any more after the projection.
    const Vec3d p{0, -1, -4}, d = normalized(Vec3d{0, -1, -2}), l = mirrored<double>(d, {0, 1, 0});
    const auto angle =
        [&](const Vec3d& direction) { // with the floor, which stays y / −z = …: along its image
            const Vec3d along = perspective(p + Vec3d{0, 0, -0.001}) - perspective(p);
            const Vec3d moved = perspective(p + 0.001 * direction) - perspective(p);
            return std::acos(dot(along, moved) / length(along) / length(moved));
        };
    EXPECT_GT(std::abs(angle(-d) - (std::acos(-1.0) - angle(l))), 0.05);
}

} // namespace
} // namespace rayscope::test
