#include "core/math/transform.hpp"

#include "tests/support/effort.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/matrices.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

double distance_to(const Vec3d& p, const WideVec& exact, int axis) {
    const Wide d = Wide(p[axis]) - exact[std::size_t(axis)];
    return double(d < 0 ? -d : d);
}

TEST(Transform, moves_a_ray_within_the_stated_error_also_far_from_the_origin) {
    Random random(11);
    for (int i = 0; i < samples(2000); ++i) {
        const Mat4d m = translation(random.in_cube(random.decade(0, 9))) * random_matrix(random);
        const Ray<double> ray{Vec3d{m[3]} + random.in_cube(20), random.direction()};
        const Transform<double> transform(m);
        const Ray<double> moved = transform.to_object(ray);
        const WideRay exact = exact_object_ray(m, ray);
        const double t = random.uniform(-20, 20);
        const Vec3d bound = transform.point_error(ray, t) * (4 * epsilon<double>);
        for (int axis = 0; axis < 3; ++axis) {
            ASSERT_LE(distance_to(moved.at(t), exact.at(Wide(t)), axis), bound[axis])
                << hex(m) << hex(ray) << hex(t);
            ASSERT_LE(bound[axis], 1e-10) << "a bound that says nothing: " << hex(m) << hex(ray);
        }
        ASSERT_EQ(moved.origin, transform.point_to_object(ray.origin));
    }
}

TEST(Transform, the_point_error_adds_the_sizes_of_both_products) {
    const Transform<double> transform(translation({1, 2, 3}) * scaling(0.5, 0.25, -1));
    const Ray<double> ray{{0, 4, 5}, {1, -1, 2}};
    EXPECT_EQ(transform.point_error(ray, -3), (Vec3d{2 * 1 + 3 * 2, 4 * 2 + 3 * 4, 2 + 3 * 2}));
}

TEST(Transform, normals_follow_the_inverse_transpose) {
    const double h = std::sqrt(0.5);
    // A shear x += z tilts the plane x = 0, whose normal was +x.
    const Vec3d n = Transform<double>(shearing(1)).normal_to_world({1, 0, 0});
    EXPECT_NEAR(n.x, h, 1e-15);
    EXPECT_EQ(n.y, 0);
    EXPECT_NEAR(n.z, -h, 1e-15);
    const Vec3d squeezed = Transform<double>(scaling(2, 1, 1)).normal_to_world({1, 1, 0});
    EXPECT_NEAR(squeezed.x, 1 / std::sqrt(5.0), 1e-15);
    EXPECT_NEAR(squeezed.y, 2 / std::sqrt(5.0), 1e-15);
    EXPECT_EQ(Transform<double>(scaling(-1, 1, 1)).normal_to_world({1, 0, 0}), (Vec3d{-1, 0, 0})); // mirrored
}

TEST(Transform, a_normal_stays_at_right_angles_to_its_tangents) {
    Random random(12);
    for (int i = 0; i < samples(1000); ++i) {
        const Mat4d m = random_matrix(random);
        const Vec3d n = random.direction() * random.decade(-3, 3), tangent = cross(n, random.direction());
        const Vec3d world = Transform<double>(m).normal_to_world(n);
        const Vec3d moved = transformed_vector(m, tangent);
        ASSERT_NEAR(dot(world, world), 1, 1e-15) << hex(m) << hex(n);
        ASSERT_NEAR(dot(world, normalized(moved)), 0, 1e-13) << hex(m) << hex(n);
        ASSERT_GT(dot(world, transformed_vector(m, n)), 0) << hex(m) << hex(n);
    }
}

TEST(Transform, a_matrix_that_flattens_space_is_refused) {
    EXPECT_TRUE(is_invertible(Mat4d{1}));
    EXPECT_TRUE(is_invertible(scaling(1e-100, 1e100, -1)));
    EXPECT_FALSE(is_invertible(scaling(1, 0, 1)));
    Mat4d dependent{1};
    dependent[1] = dependent[0] * 3.0;
    EXPECT_FALSE(is_invertible(dependent));
    EXPECT_FALSE(is_invertible(scaling(5e-324))) << "its inverse is no double";
    for (int column = 0; column < 4; ++column)
        for (const double bad : {infinity<double>, -infinity<double>, std::nan("")}) {
            Mat4d m{1};
            m[column][1] = bad;
            EXPECT_FALSE(is_invertible(m)) << column << ' ' << bad;
        }
}

// A rotation matrix is itself rounded: most still count, none is given a wrong scale, and a real distortion never passes.
TEST(Transform, similarities_are_recognized) {
    Random random(13);
    int recognized = 0;
    for (int i = 0; i < 1000; ++i) {
        const double scale = random.decade(-6, 6);
        const Mat4d m = translation(random.in_cube(9)) * random_rotation(random) * scaling(scale);
        for (const Mat4d& round : {m, m * scaling(1, -1, 1)}) {
            const double found = similarity_scale<double>(round);
            if (found == 0) continue;
            ++recognized;
            ASSERT_NEAR(found / scale, 1, 2e-15) << hex(round);
        }
        for (const Mat4d& distorted :
             {scaling(1 + 1e-12, 1, 1), scaling(1, 1, 1 - 1e-12), shearing(1e-12), scaling(1, 1 - 1e-12, 1)})
            ASSERT_EQ(similarity_scale<double>(m * distorted), 0) << hex(m * distorted);
    }
    EXPECT_GT(recognized, 1000);
    EXPECT_EQ(similarity_scale<double>(translation({1, 2, 3}) * scaling(-3)), 3);
    EXPECT_EQ(similarity_scale<double>(rotation({0, 0, 1}, 90) * scaling(0.3)), 0.3);
}

} // namespace
} // namespace rayscope::test
