// What holds for every generic, matrix and ray.

#include "tests/support/effort.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/matrices.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

std::string described(const Generic<double>& shape, const Mat4d& m, const Ray<double>& ray,
                      std::uint64_t seed) {
    return std::string(generic_name(shape)) + " matrix " + hex(m) + " ray " + hex(ray) + " seed " +
           std::to_string(seed);
}

std::vector<double> ends_of(const Intervals<double>& list) {
    std::vector<double> ends;
    for (const Interval<double>& span : list) {
        ends.push_back(span.enter);
        ends.push_back(span.exit);
    }
    return ends;
}

// Between two ends, and beyond the outermost ones, the ray is inside exactly if the list says so.
void expect_right_between_ends(const Solid<double>& solid, const Mat4d& m, const Ray<double>& ray,
                               const Intervals<double>& list, double clearance, const std::string& what) {
    std::vector<double> ends{-infinity<double>};
    for (const double end : ends_of(list))
        if (std::isfinite(end)) ends.push_back(end);
    ends.push_back(infinity<double>);
    bool inside = list.count > 0 && list.items[0].enter == -infinity<double>;
    const WideRay exact = exact_object_ray(m, ray);
    for (std::size_t i = 0; i + 1 < ends.size(); ++i, inside = !inside) {
        const double low = ends[i], high = ends[i + 1];
        if (high - low <= clearance) continue;
        const double middle = std::isfinite(low)
                                  ? (std::isfinite(high) ? (low + high) / 2 : low + 0.5 + clearance)
                                  : (std::isfinite(high) ? high - 0.5 - clearance : 0.0);
        ASSERT_EQ(exactly_inside(solid.shape, exact.at(Wide(middle))), inside)
            << "t " << hex(middle) << ' ' << what;
        const Vec3d p = solid.transform.to_object(ray).at(middle);
        const double value = implicit_value(solid.shape, p);
        if (std::abs(value) > 1e-9) {
            ASSERT_EQ(value < 0, inside) << "implicit value, t " << hex(middle) << ' ' << what;
        }
    }
}

TEST(Intervals, are_where_the_point_is_inside) {
    for (const Generic<double>& shape : solid_generics())
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(3000)); ++seed) {
            Random random(seed);
            const Mat4d m = random_matrix(random);
            Ray<double> ray = random.towards_unit_cube(4);
            ray = {transformed_point(m, ray.origin), transformed_vector(m, ray.direction)};
            const Solid<double> solid = placed(shape, m);
            expect_right_between_ends(solid, m, ray, solid.intervals(ray), 1e-7,
                                      described(shape, m, ray, seed));
            if (HasFatalFailure()) return;
        }
}

// The exact surface is crossed within the error bound of each end, in the direction that the list says. Where the two
// ends of a chord lie within their bounds of each other both answers are right.
TEST(Intervals, ends_are_within_their_error_bounds_also_from_afar) {
    int checked = 0;
    for (const Generic<double>& shape : solid_generics())
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(3000)); ++seed) {
            Random random(seed);
            const Mat4d m = translation(random.in_cube(random.decade(0, 7))) * random_matrix(random);
            Ray<double> ray = random.towards_unit_cube(random.decade(0, 7));
            ray = {transformed_point(m, ray.origin), transformed_vector(m, ray.direction)};
            ray.direction = normalized(ray.direction);
            const Solid<double> solid = placed(shape, m);
            const WideRay exact = exact_object_ray(m, ray);
            for (const Interval<double>& span : solid.intervals(ray))
                for (const bool entering : {true, false}) {
                    const double t = entering ? span.enter : span.exit;
                    const int face = entering ? span.enter_face : span.exit_face;
                    const double bound = solid.error_bound(ray, t, face);
                    if (!std::isfinite(t) || bound > (span.exit - span.enter) / 4 || bound > 0.001) continue;
                    const bool before = face_value(shape, face, exact.at(Wide(t) - Wide(bound))) < 0;
                    const bool after = face_value(shape, face, exact.at(Wide(t) + Wide(bound))) < 0;
                    ASSERT_TRUE(before == !entering && after == entering)
                        << "t " << hex(t) << " bound " << hex(bound) << " face " << face << ' '
                        << described(shape, m, ray, seed);
                    ASSERT_GE(bound, 0);
                    ++checked;
                }
        }
    EXPECT_GT(checked, samples(9 * 3000) / 2);
}

TEST(Intervals, are_ascending_and_numbers_whatever_the_ray) {
    const std::vector<double> odd{0.0, -0.0, 1.0, -1.0, 0.5, 1e-100, -1e100, 1e-300, 2.0, 0.25};
    for (const Generic<double>& shape : all_generics())
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(20000)); ++seed) {
            Random random(seed);
            Ray<double> ray{random.in_cube(2), random.direction() * random.decade(-100, 100)};
            for (int axis = 0; axis < 3; ++axis) {
                if (random.below(3) == 0) ray.origin[axis] = odd[std::size_t(random.below(int(odd.size())))];
                if (random.below(3) == 0) ray.direction[axis] = odd[std::size_t(random.below(3))];
            }
            if (ray.direction == Vec3d{0}) continue;
            const int leaving = random.below(4) == 0 ? random.below(3) : no_face;
            double last = -infinity<double>;
            for (const Interval<double>& span : intervals(shape, ray, leaving)) {
                const std::string what = described(shape, Mat4d{1}, ray, seed);
                ASSERT_FALSE(std::isnan(span.enter) || std::isnan(span.exit)) << what;
                ASSERT_LE(last, span.enter) << what;
                if (is_solid(shape)) {
                    ASSERT_LT(span.enter, span.exit) << what;
                } else {
                    ASSERT_EQ(span.enter, span.exit) << what;
                }
                last = span.exit;
            }
        }
}

TEST(Intervals, a_direction_twice_as_long_halves_every_t_bit_for_bit) {
    for (const Generic<double>& shape : all_generics())
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(1000)); ++seed) {
            Random random(seed);
            const Ray<double> ray = random.towards_unit_cube(3);
            const double factor = std::ldexp(1.0, random.below(600) - 300);
            const auto once = ends_of(intervals(shape, ray));
            auto scaled = ends_of(intervals(shape, {ray.origin, ray.direction * factor}));
            for (double& t : scaled) t *= factor;
            ASSERT_EQ(scaled, once) << hex(factor) << ' ' << described(shape, Mat4d{1}, ray, seed);
        }
}

// A ray that starts on a face: that crossing is t = 0, and everything else is as it was.
TEST(Intervals, leaving_a_face_keeps_the_other_crossings) {
    int zeros = 0, starts = 0;
    for (const Generic<double>& shape : solid_generics())
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(2000)); ++seed) {
            Random random(seed);
            const Mat4d m = random_matrix(random);
            const Solid<double> solid = placed(shape, m);
            const Ray<double> object_ray = random.towards_unit_cube(3);
            const Ray<double> first{transformed_point(m, object_ray.origin),
                                    normalized(transformed_vector(m, object_ray.direction))};
            for (const Interval<double>& span : solid.intervals(first))
                for (const bool entered : {true, false}) {
                    const double t = entered ? span.enter : span.exit;
                    const int face = entered ? span.enter_face : span.exit_face;
                    if (!std::isfinite(t)) continue;
                    const Ray<double> ray{first.at(t), random.direction()};
                    const double slope = dot(solid.normal(first, t, face), ray.direction);
                    if (std::abs(slope) < 0.01) continue;
                    const Intervals<double> list = solid.intervals(ray, face);
                    const std::string what =
                        "leaving " + std::to_string(face) + ' ' + described(shape, m, ray, seed);
                    expect_right_between_ends(solid, m, ray, list, 1e-7, what);
                    if (HasFatalFailure()) return;
                    ++starts;
                    for (const Interval<double>& s : list) {
                        if (slope < 0 && s.enter == 0 && s.enter_face == face) ++zeros;
                        if (slope > 0 && s.exit == 0 && s.exit_face == face) ++zeros;
                    }
                    const Intervals<double> naive = solid.intervals(ray);
                    for (const double end : ends_of(naive)) {
                        if (!std::isfinite(end) || std::abs(end) < 1e-7) continue;
                        bool found = false;
                        for (const double other : ends_of(list))
                            found = found || std::abs(other - end) <= 1e-9 * (1 + std::abs(end));
                        ASSERT_TRUE(found) << "lost t " << hex(end) << ' ' << what;
                    }
                }
        }
    EXPECT_GE(zeros, starts - starts / 1000) << "of " << starts; // at a rim another face may cut it away
}

} // namespace
} // namespace rayscope::test
