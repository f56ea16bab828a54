// Guards against a penumbra of the wrong width, and against noise that changes from run to run.

#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rayscope::test {
namespace {

constexpr double light_height = 10, edge_height = 4, half_width = 1;

// A wall's edge over a floor, lit by a light of a given shape: how much of it the floor at x sees.
double seen_at(double x, LightArea::Shape shape, int samples, double radius = half_width) {
    SceneMaterial matt = SceneBuilder::dark();
    matt.diffuse = Colour{1};
    SceneBuilder b;
    SceneLight& lamp = b.light({0, 0, light_height});
    lamp.area.shape = shape;
    lamp.area.radius = radius;
    lamp.area.u = {half_width, 0, 0};
    lamp.area.v = {0, half_width, 0};
    if (shape == LightArea::Shape::disk) {
        lamp.area.u = {1, 0, 0};
        lamp.area.v = {0, 1, 0};
    }
    lamp.area.samples = samples;
    b.generic(Plane<double>{}, Mat4d{1}, b.material(matt), "floor");
    // Hides x < 0 at its height: thin, and far larger than the light.
    b.generic(Cube<double>{}, translation({-50, 0, edge_height}) * scaling(50, 50, 0.001), b.material(matt),
              "wall");
    const Trace trace = trace_ray(b.open(), {{x, 0, 1}, {0, 0, -1}});
    double seen = 0;
    for (const Event& event : trace.rays[0].events)
        if (const auto* lit = std::get_if<LightLit>(&event)) {
            EXPECT_EQ(lit->samples, samples);
            seen += lit->visibility.x / samples;
        }
    return seen;
}

TEST(Penumbra, is_as_wide_as_similar_triangles_make_it) {
    // The light at ±1, six above the edge: beneath it ± 4/6.
    const double reach = half_width * edge_height / (light_height - edge_height);
    constexpr int samples = 256;
    for (const auto shape : {LightArea::Shape::rectangle, LightArea::Shape::disk}) {
        EXPECT_EQ(seen_at(-reach * 1.01, shape, samples), 0);
        EXPECT_EQ(seen_at(reach * 1.01, shape, samples), 1);
        EXPECT_GT(seen_at(-reach * 0.9, shape, samples), 0);
        EXPECT_LT(seen_at(reach * 0.9, shape, samples), 1);
        for (const double x : {-0.5, 0.0, 0.25, 0.5}) {
            const double s = x / reach;
            const double expected = shape == LightArea::Shape::rectangle
                                        ? (1 + s) / 2
                                        : 0.5 + (s * std::sqrt(1 - s * s) + std::asin(s)) / 3.14159265358979;
            EXPECT_NEAR(seen_at(x, shape, samples), expected, 2.0 / std::sqrt(samples)) << x;
        }
    }
}

TEST(Penumbra, of_a_sphere_begins_where_a_ray_from_the_edge_touches_it) {
    for (const double radius : {0.5, 2.0, 5.0}) {
        // The angle between the ways from the edge to the centre and past the sphere.
        const double reach = edge_height * std::tan(std::asin(radius / (light_height - edge_height)));
        EXPECT_EQ(seen_at(-reach * 1.01, LightArea::Shape::sphere, 1024, radius), 0) << radius;
        EXPECT_GT(seen_at(-reach * 0.9, LightArea::Shape::sphere, 1024, radius), 0) << radius;
    }
}

TEST(Penumbra, of_a_sphere_is_that_of_the_disk_it_shows) {
    EXPECT_NEAR(seen_at(0.2, LightArea::Shape::sphere, 256), seen_at(0.2, LightArea::Shape::disk, 256), 0.1);
}

// From near by a sphere covers nearly half of the view: no ray may lead past it, nor all of them to its rim.
TEST(AreaLight, that_is_a_sphere_shines_from_the_part_that_is_seen) {
    LightArea area;
    area.shape = LightArea::Shape::sphere;
    area.radius = 0.5;
    for (const double distance : {0.51, 0.6, 2.0, 1e6}) {
        const Vec3d towards = distance * normalized(Vec3d{1, 2, -2});
        double mean = 0, least = 1;
        constexpr int n = 64;
        for (int i = 0; i < n * n; ++i) {
            const Vec3d offset = area.offset({(i % n + 0.5) / n, (i / n + 0.5) / n}, towards);
            EXPECT_NEAR(length(offset), area.radius, 1e-9 * distance);
            EXPECT_LE(dot(offset, towards), 1e-9); // the near side
            const double cosine = dot(normalized(towards + offset), towards) / distance;
            mean += cosine / (n * n);
            least = std::min(least, cosine);
        }
        const double outline = std::sqrt(1 - std::pow(area.radius / distance, 2));
        EXPECT_GE(least, outline - 1e-12);
        EXPECT_NEAR(mean, (1 + outline) / 2,
                    2e-3 * (1 - outline) + 1e-12); // as equal parts of the view have it
    }
}

TEST(AreaLight, of_one_sample_asks_at_a_point_of_its_own_in_each_pixel) {
    SceneBuilder b;
    SceneLight& lamp = b.light({1, 2, 5});
    lamp.area.shape = LightArea::Shape::sphere;
    lamp.area.radius = 0.5;
    SceneMaterial matt;
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(matt), "ball");
    const Workbench area = b.open();
    EXPECT_EQ(area.world.effects, EffectMask::all);
    std::set<double> aside; // of the way to the middle of the lamp
    for (int x = 76; x < 84; ++x) {
        const Trace trace = trace_pixel(area, x, 50, 160, 100);
        const auto* hit = trace.rays[0].find<BoundaryChosen>();
        const auto* lit = trace.rays[0].find<LightLit>();
        ASSERT_TRUE(hit != nullptr && lit != nullptr);
        aside.insert(length(lit->to_light - normalized(lamp.position - hit->point)));
    }
    EXPECT_EQ(aside.size(), 8U);
    b.scene().lights[0].area = {};
    EXPECT_NE(hash(render(area, RenderOptions{}).image), hash(render(b.open(), RenderOptions{}).image));
}

TEST(AreaLight, around_a_point_of_a_surface_lights_it_by_numbers) {
    for (const LightArea::Shape shape : {LightArea::Shape::sphere, LightArea::Shape::disk}) {
        SceneBuilder b;
        SceneLight& lamp = b.light({0, 0, 0});
        lamp.area.shape = shape;
        lamp.area.radius = 0.5;
        lamp.area.u = {1, 0, 0};
        lamp.area.v = {0, 1, 0};
        lamp.area.samples = 16;
        b.generic(Plane<double>{}, Mat4d{1}, b.material(SceneMaterial{}), "floor");
        const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {0, 0, -1}});
        EXPECT_GE(largest_component(trace.colour), 0);
        EXPECT_LT(largest_component(trace.colour), 10);
    }
}

} // namespace
} // namespace rayscope::test
