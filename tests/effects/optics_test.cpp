// Guards against a wrong amount or a wrong way of light: each effect alone, against values in closed form.

#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rayscope::test {
namespace {

const double degree = std::numbers::pi / 180;

SceneMaterial glass(double index, Mirror mirror = Mirror::fresnel) {
    SceneMaterial m = SceneBuilder::dark();
    m.name = "glass";
    m.speed = 1 / index;
    m.mirror = mirror;
    return m;
}

// All light is followed, however little it is.
SceneBuilder followed_to_the_end() {
    SceneBuilder b;
    b.scene().limits.max_depth = 200;
    b.scene().limits.min_weight = 0;
    return b;
}

template <typename E> std::vector<const E*> all_of(const Trace& trace) {
    std::vector<const E*> found;
    for (const TracedRay& ray : trace.rays)
        for (const Event& event : ray.events)
            if (const E* e = std::get_if<E>(&event)) found.push_back(e);
    return found;
}

// Rs, Rp by the sines and tangents of the two angles: another form than the core's.
double reflectance(double theta, double index) {
    const double inside = std::asin(std::sin(theta) / index);
    if (theta == 0) return std::pow((index - 1) / (index + 1), 2);
    const double s = std::sin(theta - inside) / std::sin(theta + inside);
    const double p = std::tan(theta - inside) / std::tan(theta + inside);
    return (s * s + p * p) / 2;
}

TEST(Slab, lets_through_what_two_faces_and_the_glass_leave) {
    const Vec3d absorption{0.3, 0, 2};
    const double index = 1.5, thickness = 0.8;
    for (const double theta : {0.0, 20 * degree, 45 * degree, 80 * degree}) {
        SceneBuilder b = followed_to_the_end();
        SceneMaterial m = glass(index);
        m.absorption = absorption;
        b.generic(Cube<double>{}, scaling(1e6, 1e6, thickness / 2), b.material(m), "slab");
        b.generic(Plane<double>{}, translation({0, 0, -10}), b.glowing({1, 1, 1}), "floor");
        const Vec3d d{std::sin(theta), 0, -std::cos(theta)};
        const Trace trace = trace_ray(b.open(), {{0, 0, 5}, d});
        const double r = reflectance(theta, index);
        const double way = thickness / std::cos(std::asin(std::sin(theta) / index));
        for (int i = 0; i < 3; ++i) {
            const double passed = std::exp(-absorption[i] * way);
            const double expected = (1 - r) * (1 - r) * passed / (1 - r * r * passed * passed);
            EXPECT_NEAR(trace.colour[i], expected, 1e-9) << theta / degree << "°, colour " << i;
        }
    }
}

TEST(Fresnel, at_brewsters_angle_one_polarization_is_not_reflected) {
    for (const double index : {1.2, 1.5, 2.4}) {
        SceneBuilder b;
        b.generic(Plane<double>{}, Mat4d{1}, b.material(glass(index)), "glass");
        const double theta = std::atan(index);
        const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {std::sin(theta), 0, -std::cos(theta)}});
        const auto shares = all_of<FresnelShared>(trace);
        ASSERT_FALSE(shares.empty());
        EXPECT_LT(shares[0]->parallel, 1e-30);
        const double s = (index * index - 1) / (index * index + 1);
        EXPECT_NEAR(shares[0]->reflected, s * s / 2, 1e-15);
    }
}

TEST(Fresnel, schlick_is_exact_straight_on_and_at_a_graze_and_near_between) {
    for (const double theta : {0.0, 30 * degree, 60 * degree, 85 * degree, 89.9999 * degree}) {
        SceneBuilder b;
        b.generic(Plane<double>{}, Mat4d{1}, b.material(glass(1.5, Mirror::schlick)), "glass");
        const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {std::sin(theta), 0, -std::cos(theta)}});
        const auto shares = all_of<FresnelShared>(trace);
        ASSERT_FALSE(shares.empty());
        EXPECT_EQ(shares[0]->reflected, shares[0]->schlick);
        EXPECT_NEAR(shares[0]->schlick, reflectance(theta, 1.5), theta == 0 ? 1e-15 : 0.04);
    }
}

TEST(Fresnel, where_the_medium_stays_the_same_nothing_is_reflected) {
    for (const Mirror mirror : {Mirror::fresnel, Mirror::schlick}) {
        SceneBuilder b;
        const std::size_t material = b.material(glass(1.5, mirror));
        b.generic(Cube<double>{}, Mat4d{1}, material, "left");
        b.generic(Cube<double>{}, translation({2, 0, 0}), material, "right");
        const Trace trace =
            trace_ray(b.open(), {{0.9, -0.9, 0}, {std::sin(10 * degree), std::cos(10 * degree), 0}});
        const auto shares =
            all_of<FresnelShared>(trace); // the ray leaves one block for the other, at a graze
        ASSERT_FALSE(shares.empty());
        EXPECT_EQ(shares[0]->reflected, 0);
    }
}

TEST(Fresnel, beyond_the_critical_angle_everything_is_reflected) {
    const double index = 1.5, critical = std::asin(1 / index);
    for (const double beside : {-1e-12, 1e-12}) {
        SceneBuilder b = followed_to_the_end();
        b.scene().background = Colour{1};
        b.generic(Plane<double>{}, Mat4d{1}, b.material(glass(index)), "glass");
        const double theta = critical + beside;
        const Trace trace = trace_ray(b.open(), {{0, 0, -5}, {std::sin(theta), 0, std::cos(theta)}});
        EXPECT_EQ(all_of<TotallyReflected>(trace).size(), beside > 0 ? 1U : 0U);
        EXPECT_EQ(all_of<Refracted>(trace).size(), beside > 0 ? 0U : 1U);
    }
}

// In the plane y = 0, with its edge upwards: two planes that make the angle, cut by the floor.
void add_prism(SceneBuilder& b, const SceneMaterial& material, double angle) {
    b.operand("left", Plane<double>{}, rotation({0, 1, 0}, -(90 - angle / degree / 2)));
    b.operand("right", Plane<double>{}, rotation({0, 1, 0}, 90 - angle / degree / 2));
    b.operand("top", Plane<double>{}, translation({0, 0, -5}) * rotation({0, 1, 0}, 180));
    b.compound("prism", "left & right & top", b.material(material));
}

TEST(Dispersion, a_prism_turns_each_colour_least_where_its_way_is_symmetric) {
    const double angle = 60 * degree;
    SceneMaterial flint = glass(1.62, Mirror::constant);
    flint.transmission = Colour{1};
    flint.dispersion = Dispersion::by_abbe_number(1.62, 36.4);
    SceneBuilder b;
    add_prism(b, flint, angle);
    b.scene().background = Colour{1};
    const Workbench bench = b.open();
    // The wavelengths of a ray given by hand are the same each time.
    const auto through = [&](double theta) {
        // Onto the left face, whose outward normal leans to the left and up.
        const double lean = 90 * degree - angle / 2;
        const Vec3d normal{-std::sin(lean), 0, std::cos(lean)};
        const Vec3d along{std::cos(lean), 0, std::sin(lean)}; // up the face
        const Vec3d d = -std::cos(theta) * normal + std::sin(theta) * along;
        const Vec3d at = -2.0 * along;
        return trace_ray(bench, {at - 3.0 * d, d});
    };
    std::vector<double> wavelengths;
    const Trace spread = through(50 * degree);
    for (const auto* bent : all_of<Refracted>(spread))
        if (bent->theta_from < 80 * degree && wavelengths.size() < 8) wavelengths.push_back(bent->wavelength);
    ASSERT_EQ(wavelengths.size(), 8U);
    for (const std::size_t i : {0U, 3U, 7U}) {
        const double index = flint.dispersion.index(wavelengths[i]);
        const Trace trace = through(std::asin(index * std::sin(angle / 2)));
        const Vec3d first = trace.rays[0].start().direction;
        bool seen = false;
        for (const TracedRay& ray : trace.rays) {
            const RaySpawned& start = ray.start();
            if (start.wavelength != wavelengths[i] || start.depth != 2 || start.kind != RayKind::refracted)
                continue;
            seen = true;
            const double turned = std::acos(std::clamp(dot(first, start.direction), -1.0, 1.0));
            EXPECT_NEAR(turned, 2 * std::asin(index * std::sin(angle / 2)) - angle, 1e-12) << wavelengths[i];
        }
        EXPECT_TRUE(seen) << wavelengths[i];
    }
}

TEST(Dispersion, one_ray_carries_all_colours_up_to_the_first_boundary_that_spreads_them) {
    SceneMaterial plain = glass(1.5), flint = glass(1.62);
    flint.dispersion = Dispersion::by_abbe_number(1.62, 36.4);
    SceneBuilder b;
    b.scene().background = Colour{1};
    b.scene().limits.max_depth = 4;
    b.generic(Cube<double>{}, translation({0, 0, 4}), b.material(plain), "plain");
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(flint), "flint");
    const Trace trace = trace_ray(b.open(), {{0.1, 0.2, 9}, normalized(Vec3d{0.05, 0, -1})});
    int white = 0, spread = 0;
    for (const TracedRay& ray : trace.rays) {
        const RaySpawned& start = ray.start();
        (start.wavelength > 0 ? spread : white) += 1;
        if (start.wavelength == 0 && ray.parent != none) {
            EXPECT_EQ(trace.rays[std::size_t(ray.parent)].start().wavelength, 0);
        }
    }
    EXPECT_GT(white, 3);
    EXPECT_GT(spread, 8);
}

TEST(Dispersion, between_two_solids_of_one_glass_is_none) {
    SceneBuilder b;
    const auto glass = b.clear(0, 1, 1.7);
    b.scene().materials[glass].dispersion = Dispersion::by_abbe_number(1.7, 20);
    b.generic(Cube<double>{}, Mat4d{1}, glass, "left");
    b.generic(Cube<double>{}, translation({2, 0, 0}), glass, "right");
    b.scene().limits.max_depth = 1;
    const Trace trace = trace_ray(b.open(), {{0, 0, 0}, {1, 0.1, 0}});
    EXPECT_EQ(trace.rays.size(), 2U);
    EXPECT_EQ(trace.rays[1].start().kind, RayKind::refracted);
}

TEST(Lens, focuses_where_the_lensmaker_says) {
    const double radius = 20, index = 1.5, thickness = 0.02;
    SceneBuilder b;
    const double apart = radius - thickness / 2;
    b.operand("front", Sphere<double>{radius}, translation({0, 0, -apart}));
    b.operand("back", Sphere<double>{radius}, translation({0, 0, apart}));
    b.compound("lens", "front & back", b.clear(0, 1, index));
    for (const double height : {0.01, 0.05}) {
        const Trace trace = trace_ray(b.open(), {{height, 0, 5}, {0, 0, -1}});
        ASSERT_EQ(trace.rays.size(), 3U);
        const RaySpawned& out = trace.rays[2].start();
        const double focus = -(out.origin.z - out.origin.x / out.direction.x * out.direction.z);
        const double n = index;
        const double expected = 1 / ((n - 1) * (2 / radius - (n - 1) * thickness / (n * radius * radius)));
        EXPECT_NEAR(focus, expected, 0.01) << height;
    }
}

TEST(Furnace, glass_of_all_kinds_neither_makes_nor_swallows_light) {
    SceneMaterial flint = glass(1.62);
    flint.dispersion = Dispersion::by_abbe_number(1.62, 36.4);
    for (const SceneMaterial& material : {glass(1.5), glass(1.5, Mirror::schlick), flint}) {
        SceneBuilder b = followed_to_the_end();
        b.scene().limits.max_depth = 60;
        b.scene().background = Colour{1};
        b.generic(Sphere<double>{}, Mat4d{1}, b.material(material), "ball");
        const Workbench bench = b.open();
        for (const double x : {0.0, 0.3, 0.7, 0.95}) {
            const Colour colour = trace_ray(bench, {{x, 0, 5}, {0, 0, -1}}).colour;
            for (int i = 0; i < 3; ++i) EXPECT_NEAR(colour[i], 1, 1e-9) << x;
        }
    }
}

TEST(Absorption, is_of_the_way_in_the_medium_of_the_highest_priority) {
    SceneMaterial water = glass(1.0, Mirror::constant), ice = water;
    water.transmission = ice.transmission = Colour{1};
    water.absorption = Colour{0.1};
    ice.absorption = Colour{0.7};
    SceneBuilder b;
    b.generic(Sphere<double>{}, scaling(3), b.material(water), "water");
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(ice), "ice", 1);
    b.generic(Plane<double>{}, translation({0, 0, -10}), b.glowing({1, 1, 1}), "floor");
    const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {0, 0, -1}});
    EXPECT_NEAR(trace.colour.x, std::exp(-(0.1 * 4 + 0.7 * 2)), 1e-14);
    double ways = 0;
    for (const auto* e : all_of<Absorbed>(trace)) ways += e->length;
    EXPECT_NEAR(ways, 6, 1e-14);
}

TEST(Absorption, dims_a_shadow_ray_on_its_way_as_well) {
    SceneMaterial water = glass(1.33, Mirror::constant);
    water.transmission = Colour{0.9};
    water.absorption = Colour{0.25};
    SceneMaterial matt = SceneBuilder::dark();
    matt.diffuse = Colour{1};
    SceneBuilder b;
    b.light({0, 0, 8});
    b.generic(Cube<double>{}, translation({0, 0, 3}), b.material(water), "water");
    b.generic(Plane<double>{}, Mat4d{1}, b.material(matt), "floor");
    const Trace trace = trace_ray(b.open(), {{2, 0, 1}, normalized(Vec3d{-2, 0, -1})});
    EXPECT_NEAR(trace.colour.x, 0.9 * 0.9 * std::exp(-0.25 * 2), 1e-12);
}

} // namespace
} // namespace rayscope::test
