// The schoolbook's formulas: right where it is easy, and wrong where they are known to be.

#include "tests/support/matrices.hpp"
#include "tests/support/random.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

template <Numbers N> Solid<N> solid(const Generic<double>& shape, const Mat4d& matrix) {
    Solid<N> s;
    s.shape = to_numbers<N>(shape);
    s.transform = Transform<N>(matrix);
    return s;
}

template <Numbers N>
std::vector<double> crossings_of(const Generic<double>& shape, const Mat4d& matrix, const Ray<double>& ray) {
    std::vector<double> t;
    for (const auto& inside : solid<N>(shape, matrix).intervals(as<ScalarOf<N>>(ray))) {
        t.push_back(double(inside.enter));
        t.push_back(double(inside.exit));
    }
    return t;
}

TEST(Textbook, agrees_with_the_stable_formulas_on_easy_rays) {
    Random random(5);
    const Mat4d matrix = translation({0.3, -0.2, 0.1}) * scaling(1.5, 0.8, 1.1);
    for (const Generic<double>& shape : all_generics()) {
        int differing = 0, hits = 0;
        for (int n = 0; n < 2000; ++n) {
            const Ray<double> ray = random.towards_unit_cube(4);
            const auto stable = crossings_of<double>(shape, matrix, ray);
            const auto school = crossings_of<Textbook<double>>(shape, matrix, ray);
            hits += stable.empty() ? 0 : 1;
            bool same = stable.size() == school.size();
            for (std::size_t i = 0; same && i < stable.size(); ++i)
                same = stable[i] == school[i] ||
                       std::abs(stable[i] - school[i]) <= 1e-8 * (1 + std::abs(stable[i]));
            differing += same ? 0 : 1;
        }
        EXPECT_GT(hits, 100) << shape.index();
        EXPECT_LE(differing, 2) << shape.index(); // a graze or an edge
    }
}

// How many of 1000 rays at a small thing far away lose a crossing, or more than half their digits.
template <Numbers N> int wrong_far_away(const Generic<double>& shape, double distance) {
    Random random(6);
    int wrong = 0;
    for (int n = 0; n < 1000; ++n) {
        const Vec3d middle = random.direction() * distance;
        const Ray<double> ray{{0, 0, 0}, normalized(middle + random.in_cube(0.9))};
        const Mat4d matrix = translation(middle);
        const auto exact = crossings_of<Float128>(shape, matrix, as<double>(as<ScalarOf<N>>(ray)));
        const auto found = crossings_of<N>(shape, matrix, ray);
        bool right = exact.size() == found.size();
        for (std::size_t i = 0; right && i < exact.size(); ++i)
            right = exact[i] == found[i] ||
                    std::abs(exact[i] - found[i]) <= double(sqrt(epsilon<ScalarOf<N>>)) * distance;
        wrong += right ? 0 : 1;
    }
    return wrong;
}

TEST(Textbook, a_far_sphere_is_lost_and_the_stable_one_is_not) {
    EXPECT_GT(wrong_far_away<Textbook<float>>(Sphere<double>{}, 1e4), 100);
    EXPECT_LT(wrong_far_away<float>(Sphere<double>{}, 1e4), 10);
    EXPECT_GT(wrong_far_away<Textbook<double>>(Sphere<double>{}, 1e9), 100);
    EXPECT_LT(wrong_far_away<double>(Sphere<double>{}, 1e9), 20);
}

TEST(Textbook, a_far_torus_is_lost_and_the_stable_one_is_not) {
    EXPECT_GT(wrong_far_away<Textbook<double>>(Torus<double>{}, 1e5), 100);
    EXPECT_LT(wrong_far_away<double>(Torus<double>{}, 1e5), 10);
}

TEST(Textbook, has_no_error_bounds_and_starts_beside_the_surface) {
    const auto school = solid<Textbook<double>>(Sphere<double>{}, Mat4d{1});
    const Ray<double> ray{{0, 0.1, 5}, {0, 0, -1}};
    EXPECT_EQ(school.error_bound(ray, 4, 0), 0);
    EXPECT_GT(solid<double>(Sphere<double>{}, Mat4d{1}).error_bound(ray, 4, 0), 0);
    EXPECT_GT(secondary_start<Textbook<float>>, 0.0F);
    EXPECT_EQ(secondary_start<float>, 0.0F);
}

} // namespace
} // namespace rayscope::test
