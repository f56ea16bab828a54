#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/matrices.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// Gradient of the implicit value in world space, by central differences.
Vec3d slope_of_value(const Solid<double>& solid, const Vec3d& at) {
    constexpr double step = 0x1p-18;
    Vec3d gradient{0};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d offset{0};
        offset[axis] = step;
        gradient[axis] = implicit_value(solid.shape, solid.transform.point_to_object(at + offset)) -
                         implicit_value(solid.shape, solid.transform.point_to_object(at - offset));
    }
    return normalized(gradient);
}

TEST(Normal, is_unit_and_points_outward_also_under_shear_and_mirror) {
    int checked = 0, agree = 0;
    for (const Generic<double>& shape : solid_generics())
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(1000)); ++seed) {
            Random random(seed);
            const Mat4d m = random_matrix(random);
            const Solid<double> solid = placed(shape, m);
            const Ray<double> object_ray = random.towards_unit_cube(3);
            const Ray<double> ray{transformed_point(m, object_ray.origin),
                                  transformed_vector(m, object_ray.direction)};
            for (const Interval<double>& span : solid.intervals(ray))
                for (const bool entering : {true, false}) {
                    const double t = entering ? span.enter : span.exit;
                    if (!std::isfinite(t)) continue;
                    const Vec3d n = solid.normal(ray, t, entering ? span.enter_face : span.exit_face);
                    const std::string what = std::string(generic_name(shape)) + ' ' + hex(m) + hex(ray) +
                                             hex(t) + " seed " + std::to_string(seed);
                    ASSERT_NEAR(dot(n, n), 1, 1e-15) << what;
                    ASSERT_TRUE(entering ? dot(n, ray.direction) <= 0 : dot(n, ray.direction) >= 0) << what;
                    const Vec3d slope = slope_of_value(solid, ray.at(t));
                    ++checked;
                    if (dot(slope, n) > 0.9999) ++agree; // near rims the difference reaches around the corner
                }
        }
    EXPECT_GT(agree, checked - checked / 100) << "of " << checked;
}

TEST(Normal, each_face_has_its_own) {
    EXPECT_EQ(Cylinder<double>{}.normal({0.6, 0.8, 0.3}, 0), (Vec3d{0.6, 0.8, 0}));
    EXPECT_EQ(Cylinder<double>{}.normal({0.1, 0, -1}, 1), (Vec3d{0, 0, -1}));
    EXPECT_EQ(Cylinder<double>{}.normal({0.1, 0, 1}, 2), (Vec3d{0, 0, 1}));
    EXPECT_EQ(Cone<double>{0.5}.normal({0.1, 0, -1}, 1), (Vec3d{0, 0, -1}));
    EXPECT_EQ(Cone<double>{0.5}.normal({0.1, 0, 1}, 2), (Vec3d{0, 0, 1}));
    const Vec3d wall = normalized(Cone<double>{}.normal({0.5, 0, 0}, 0));
    EXPECT_NEAR(wall.x, 2 / std::sqrt(5.0), 1e-15);
    EXPECT_NEAR(wall.z, 1 / std::sqrt(5.0), 1e-15);
    EXPECT_EQ(Cone<double>{}.normal({0, 0, 1}, 0), (Vec3d{0, 0, 1})); // the apex
    for (int face = 0; face < 6; ++face) {
        Vec3d n{0};
        n[face / 2] = face % 2 == 0 ? -1 : 1;
        EXPECT_EQ(Cube<double>{}.normal({}, face), n);
    }
    EXPECT_EQ(Plane<double>{}.normal({5, 5, 0}, 0), (Vec3d{0, 0, 1}));
    EXPECT_EQ(normalized(Torus<double>{0.25}.normal({1.25, 0, 0}, 0)), (Vec3d{1, 0, 0}));
    EXPECT_EQ(normalized(Torus<double>{0.25}.normal({0, 0.75, 0}, 0)), (Vec3d{0, -1, 0}));
    EXPECT_EQ(normalized(Torus<double>{0.25}.normal({1, 0, -0.25}, 0)), (Vec3d{0, 0, -1}));
    EXPECT_EQ(Torus<double>{0.25}.normal({0, 0, 0.1}, 0),
              (Vec3d{0, 0, 0.1})); // on the axis: no division by zero
    EXPECT_EQ(OpenCylinder<double>{}.normal({0.6, 0.8, 0.3}, 0), (Vec3d{0.6, 0.8, 0}));
    EXPECT_EQ(OpenCone<double>{0.25}.normal({0.5, 0, 0.3}, 0), Cone<double>{0.25}.normal({0.5, 0, 0.3}, 0));
}

// Distance near the surface, negative inside: for shapes whose value is the distance.
TEST(Value, is_about_the_distance) {
    EXPECT_DOUBLE_EQ(Sphere<double>{2}.value({0, 3, 4}), 3);
    EXPECT_EQ(Plane<double>{}.value({1, 2, -3}), -3);
    EXPECT_DOUBLE_EQ(Cylinder<double>{}.value({0, 3, 0}), 2);
    EXPECT_EQ(Cylinder<double>{}.value({0, 0.5, 0.25}), -0.5);
    EXPECT_EQ(Cylinder<double>{}.value({0, 0.5, -3}), 2);
    EXPECT_EQ(Cube<double>{}.value({0, 0.5, -3}), 2);
    EXPECT_EQ(Cube<double>{}.value({0, 0.5, -0.25}), -0.5);
    EXPECT_DOUBLE_EQ(Cone<double>{}.value({1, 0, 0}), 0.5 * 2 / std::sqrt(5.0));
    EXPECT_DOUBLE_EQ(Cone<double>{}.value({0, 0, -3}), 2);
    EXPECT_DOUBLE_EQ(Cone<double>{0.5}.value({0, 0.25, 0.75}), -0.25);
    EXPECT_DOUBLE_EQ(Torus<double>{0.25}.value({2, 0, 0}), 0.75);
    EXPECT_DOUBLE_EQ(Torus<double>{0.25}.value({0, -1, 0.125}), -0.125);
    EXPECT_EQ(triangle().value({0, 0, -2}), 2);
    EXPECT_DOUBLE_EQ(OpenCylinder<double>{}.value({0, 3, 0}), 2);
    EXPECT_DOUBLE_EQ(OpenCone<double>{0.5}.value({0, 0.25, 0.75}), -0.25);
}

// The second derivative of the surface's function along the ray, its gradient taken as unit.
TEST(Curvature, is_what_a_small_step_shows) {
    EXPECT_EQ(Sphere<double>{2}.curvature({2, 0, 0}, {0, 3, 0}, 0), 4.5);
    EXPECT_EQ(Plane<double>{}.curvature({}, {1, 2, 3}, 0), 0);
    EXPECT_EQ(Cylinder<double>{}.curvature({1, 0, 0}, {0, 3, 7}, 0), 9);
    EXPECT_EQ(Cylinder<double>{}.curvature({0, 0, 1}, {0, 3, 7}, 2), 0);
    EXPECT_EQ(Cube<double>{}.curvature({1, 0, 0}, {1, 1, 1}, 1), 0);
    EXPECT_EQ(Cone<double>{}.curvature({0, 0, -1}, {1, 1, 0}, 1), 0);
    // x² + y² − w², gradient (x, y, slope·w) of length √(¼ + 1/16) at (½, 0, 0); along y the second derivative is 1.
    EXPECT_DOUBLE_EQ(Cone<double>{}.curvature({0.5, 0, 0}, {0, 1, 0}, 0), 1 / std::sqrt(0.3125));
    EXPECT_DOUBLE_EQ(Cone<double>{}.curvature({0.5, 0, 0}, {0, 0, 2}, 0), 1 / std::sqrt(0.3125));
    EXPECT_DOUBLE_EQ(OpenCone<double>{}.curvature({0.5, 0, 0}, {0, 1, 0}, 0), 1 / std::sqrt(0.3125));
    EXPECT_EQ(OpenCylinder<double>{}.curvature({1, 0, 0}, {0, 3, 7}, 0), 9);
    const Torus<double> torus{0.25};
    EXPECT_DOUBLE_EQ(torus.curvature({1.25, 0, 0}, {0, 0, 2}, 0), 16);       // around the tube
    EXPECT_DOUBLE_EQ(torus.curvature({1.25, 0, 0}, {0, 2, 0}, 0), 4 / 1.25); // around the axis, outside …
    EXPECT_DOUBLE_EQ(torus.curvature({0, 0.75, 0}, {1, 0, 0}, 0), 1 / 0.75); // … inside, the other way …
    EXPECT_EQ(torus.curvature({1, 0, 0.25}, {0, 3, 0}, 0), 0);               // … on top not at all
    EXPECT_NEAR(torus.curvature({0.75, 0, 0}, {0, std::sqrt(3.0), 1}, 0), 0, 1e-15); // an asymptotic line
}

TEST(Bounds, hold_every_crossing) {
    for (const Generic<double>& shape : all_generics()) {
        const Box<double> box = std::visit([](const auto& s) { return s.bounds(); }, shape);
        Vec3d widest{0};
        for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
            Random random(seed);
            const Ray<double> ray = random.towards_unit_cube(3);
            for (const Interval<double>& span : intervals(shape, ray))
                for (const double t : {span.enter, span.exit}) {
                    if (!std::isfinite(t)) continue;
                    const Vec3d p = ray.at(t);
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_LE(p[axis], box.high[axis] + 1e-14) << generic_name(shape) << hex(ray);
                        ASSERT_GE(p[axis], box.low[axis] - 1e-14) << generic_name(shape) << hex(ray);
                        widest[axis] = std::max(widest[axis], std::abs(p[axis]));
                    }
                }
        }
        for (int axis = 0; axis < 3; ++axis) // and are not wider than they need to be
            if (std::isfinite(box.high[axis])) {
                EXPECT_GT(widest[axis], box.high[axis] * 0.9) << generic_name(shape);
            }
    }
}

} // namespace
} // namespace rayscope::test
