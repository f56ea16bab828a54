// Local light and shadows, with every number worked out by hand.

#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

const Ray<double> onto_the_pole{{0, 0, 5}, {0, 0, -1}}; // meets the unit sphere at (0, 0, 1)

void expect_near(const Colour& found, const Colour& expected, double tolerance = 1e-14) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

// The light stands at (0, 3, 5): l = (0, 0.6, 0.8), n·l = 0.8, r·v = 0.8.
constexpr double cosine = 0.8, specular = 0.8 * 0.8;

struct Lit : SceneBuilder {
    Colour ambient{0.1, 0.2, 0.3}, diffuse{0.5, 0.25, 1}, shine{0.3, 0.2, 0.1}, lamp{1, 0.5, 0.25};
    Colour ambient_term, light_term;

    Lit() {
        scene().ambient = {0.5, 1, 2};
        SceneMaterial m = dark();
        m.ambient = ambient;
        m.diffuse = diffuse;
        m.specular = shine;
        m.shininess = 2;
        generic(Sphere<double>{}, Mat4d{1}, material(m));
        ambient_term = Colour{0.05, 0.2, 0.6};
        light_term = {(0.5 * cosine + 0.3 * specular) * 1, (0.25 * cosine + 0.2 * specular) * 0.5,
                      (1 * cosine + 0.1 * specular) * 0.25};
    }
    [[nodiscard]] Colour seen() const { return trace_ray(open(), onto_the_pole).colour; }
};

TEST(Light, ambient_diffuse_and_specular_add_up) {
    Lit b;
    expect_near(b.seen(), b.ambient_term);
    b.light({0, 3, 5}, b.lamp);
    expect_near(b.seen(), b.ambient_term + b.light_term);
    b.light({0, 3, 5}, b.lamp); // the second lamp adds its light and no ambient
    expect_near(b.seen(), b.ambient_term + 2.0 * b.light_term);
}

TEST(Light, does_not_fall_off_with_distance_and_a_sun_is_everywhere) {
    Lit far;
    far.light({0, 3000, 4001}, far.lamp);
    expect_near(far.seen(), far.ambient_term + far.light_term);
    Lit sunny;
    sunny.sun({0, 3, 4}, sunny.lamp);
    expect_near(sunny.seen(), sunny.ambient_term + sunny.light_term);
}

TEST(Light, behind_the_surface_it_adds_nothing_and_asks_for_no_shadow) {
    Lit b;
    b.light({0, 3, -5}, b.lamp);
    expect_near(b.seen(), b.ambient_term);
    EXPECT_EQ(trace_ray(b.open(), onto_the_pole).rays.size(), 1U);
}

TEST(Light, its_terms_are_recorded) {
    Lit b;
    b.light({0, 3, 5}, b.lamp);
    const Trace trace = trace_ray(b.open(), onto_the_pole);
    const auto* lit = trace.rays[0].find<LightLit>();
    ASSERT_NE(lit, nullptr);
    EXPECT_NEAR(lit->cosine, cosine, 1e-15);
    EXPECT_NEAR(lit->mirror_cosine, 0.8, 1e-15);
    EXPECT_EQ(lit->shininess, 2);
    EXPECT_EQ(lit->visibility, Colour{1});
    expect_near(lit->diffuse, {0.5 * cosine, 0.125 * cosine, 0.25 * cosine});
    expect_near(lit->specular, {0.3 * specular, 0.1 * specular, 0.025 * specular});
    const auto* ambient = trace.rays[0].find<AmbientLit>();
    ASSERT_NE(ambient, nullptr);
    EXPECT_EQ(ambient->scene * ambient->material, b.ambient_term);
    ASSERT_EQ(trace.rays.size(), 2U); // the shadow ray
    EXPECT_EQ(trace.rays[1].start().kind, RayKind::shadow);
    EXPECT_DOUBLE_EQ(trace.rays[1].start().reach, 5);
}

TEST(Shadow, what_stands_between_darkens_and_what_stands_beyond_does_not) {
    for (const bool between : {true, false}) {
        Lit b;
        b.light({0, 3, 5}, b.lamp);
        b.generic(Cube<double>{}, translation(between ? Vec3d{0, 1.5, 3} : Vec3d{0, 4.5, 7}) * scaling(0.3),
                  b.glowing({9, 9, 9}));
        expect_near(b.seen(), b.ambient_term + (between ? 0.0 : 1.0) * b.light_term);
        b.scene().lights[0].shadows = false;
        expect_near(b.seen(), b.ambient_term + b.light_term);
        b.scene().lights.clear();
        b.sun({0, 3, 4}, b.lamp); // a sun has nothing beyond it
        expect_near(b.seen(), b.ambient_term);
    }
}

TEST(Shadow, an_opaque_solid_around_the_light_hides_it) {
    Lit b;
    b.light({0, 3, 5}, b.lamp);
    b.generic(Sphere<double>{}, translation({0, 3, 5}) * scaling(0.5), b.glowing({1, 1, 1}));
    expect_near(b.seen(), b.ambient_term);
}

TEST(Shadow, each_boundary_of_a_transparent_blocker_takes_its_share) {
    const auto seen_through = [](const std::vector<Mat4d>& blockers) {
        Lit b;
        b.light({0, 3, 5}, b.lamp);
        double transmission = 0.5;
        for (const Mat4d& place : blockers) {
            b.generic(Sphere<double>{}, place, b.clear(0, transmission, 1.5));
            transmission /= 2;
        }
        return b.seen();
    };
    const Mat4d first = translation({0, 1.5, 3}) * scaling(0.2),
                second = translation({0, 2.25, 4}) * scaling(0.2);
    const Mat4d around_the_light = translation({0, 3, 5}) * scaling(0.5);
    Lit b;
    expect_near(seen_through({}), b.ambient_term + b.light_term);
    expect_near(seen_through({first}), b.ambient_term + 0.25 * b.light_term);
    expect_near(seen_through({first, second}), b.ambient_term + 0.25 * 0.0625 * b.light_term);
    expect_near(seen_through({around_the_light}), b.ambient_term + 0.5 * b.light_term);
    expect_near(seen_through({first, translation({0, 1.5, 3}) * scaling(0.1)}), // one within the other
                b.ambient_term + 0.25 * 0.0625 * b.light_term);
}

TEST(Shadow, blockers_are_recorded_in_their_order_along_the_ray) {
    Lit b;
    b.light({0, 3, 5}, b.lamp);
    b.generic(Sphere<double>{}, translation({0, 2.25, 4}) * scaling(0.2), b.clear(0, 0.5, 1), "far");
    b.generic(Cube<double>{}, translation({0, 1.5, 3}) * scaling(0.2), b.clear(0, 0.25, 1), "near");
    const Trace trace = trace_ray(b.open(), onto_the_pole);
    std::vector<std::string> order;
    double last = 0;
    for (const Event& event : trace.rays[1].events)
        if (const auto* passed = std::get_if<BlockerPassed>(&event)) {
            order.push_back(trace.objects[std::size_t(passed->object)].name);
            EXPECT_GT(passed->t, last);
            last = passed->t;
        }
    EXPECT_EQ(order, (std::vector<std::string>{"near", "near", "far", "far"}));
    EXPECT_EQ(std::get<RayFinished>(trace.rays[1].events.back()).colour, Colour{0.25 * 0.0625});
}

TEST(Shadow, a_sphere_that_rests_on_a_plane_shades_the_point_it_stands_on_and_little_else) {
    SceneBuilder b;
    SceneMaterial white = SceneBuilder::dark();
    white.diffuse = Colour{1};
    const auto m = b.material(white);
    b.generic(Plane<double>{}, Mat4d{1}, m);
    b.generic(Sphere<double>{}, translation({0, 0, 1}), m);
    b.light({0, 0, 100});
    const Workbench bench = b.open();
    const auto lit = [&](const Vec3d& target, const Vec3d& eye) {
        return trace_ray(bench, {eye, normalized(target - eye)}).colour.x > 0;
    };
    for (double x = 0.125; x < 3; x += 0.25) EXPECT_EQ(lit({x, 0, 0}, {x + 3, 0, 1}), x > 1.006) << x;
    for (double angle = 0.1; angle < 1.5; angle += 0.1) // its upper half is lit throughout
        EXPECT_TRUE(lit(Vec3d{std::sin(angle), 0, 1 + std::cos(angle)}, {5, 0, 6})) << angle;
}

TEST(Light, the_inner_wall_of_an_opaque_solid_is_lit_and_that_of_glass_is_not) {
    SceneBuilder opaque;
    SceneMaterial white = SceneBuilder::dark();
    white.diffuse = Colour{1};
    opaque.generic(Sphere<double>{}, scaling(4), opaque.material(white));
    opaque.light({0, 0, 2});
    EXPECT_NEAR(trace_ray(opaque.open(), {{0, 0, 0}, {0, 0, 1}}).colour.x, 1, 1e-15);
    white.transmission = Colour{0.5};
    SceneBuilder glass;
    glass.generic(Sphere<double>{}, scaling(4), glass.material(white));
    glass.light({0, 0, 2});
    const Trace trace = trace_ray(glass.open(), {{0, 0, 0}, {0, 0, 1}});
    EXPECT_EQ(trace.colour.x, 0);
    EXPECT_NE(trace.rays[0].find<LocalLightSkipped>(), nullptr);
}

} // namespace
} // namespace rayscope::test
