#include "core/world/first_of_object.hpp"

#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// What is asked of a ray that starts on an object, without the short cut for what it has left for good.
std::optional<double> first_in_list(const World<double>& world, const Ray<double>& ray,
                                    const LeavingSurface<double>& leaving) {
    Work<double> work;
    const Range<double> ahead{0};
    const auto first = first_crossing(world, ray, crossings(world, 0, ray, &leaving, work), ahead, &leaving);
    return first ? std::optional(first->t) : std::nullopt;
}

// From every boundary of a compound, and to every side.
TEST(FirstOfObject, what_a_ray_has_left_for_good_it_never_meets_again) {
    int left = 0, met = 0;
    for (const std::string expression :
         {"ball", "ball & other", "ball - other", "other - ball", "ball | other", "(ball - other) & third",
          "ball - other - third", "(ball | other) & third", "ball & slab", "ball - slab", "half & ball",
          "half - ball"}) {
        for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(400)); ++seed) {
            Random random(seed);
            SceneBuilder b;
            b.operand("ball", Sphere<double>{});
            b.operand("other", Sphere<double>{},
                      translation(random.in_cube(1)) * scaling(random.uniform(0.3, 2)));
            b.operand("third", Sphere<double>{}, translation(random.in_cube(0.5)));
            b.operand("slab", Cube<double>{},
                      translation(random.in_cube(0.5)) * scaling(2, 2, random.uniform(0.1, 1)));
            b.operand("half", Plane<double>{}, translation(random.in_cube(0.5)) * random_rotation(random));
            b.compound("whole", expression, b.glowing({1, 1, 1}));
            const Workbench bench = b.open();
            const World<double>& world = bench.world;
            const Ray<double> ray = random.towards_unit_cube(3);
            Work<double> work;
            const LeavingSurface<double>* const nothing = nullptr;
            const auto list = crossings(world, 0, ray, nothing, work);
            const std::vector<Crossing<double>> boundaries(list.begin(), list.end());
            for (const Crossing<double>& c : boundaries) {
                if (!std::isfinite(c.t)) continue;
                const LeavingSurface<double> leaving{0,     c.surface, random.coin(), random.below(4) == 0,
                                                     1e-15, 1e-14};
                const Ray<double> next{ray.at(c.t), random.direction()};
                Work<double> again;
                const auto first = first_of_object(world, 0, next, Range<double>{0}, &leaving, again);
                const auto expected = first_in_list(world, next, leaving);
                ASSERT_EQ(first.has_value(), expected.has_value())
                    << expression << " seed " << seed << hex(next);
                if (first) {
                    ASSERT_EQ(first->t, *expected) << expression << " seed " << seed << hex(next);
                }
                Work<double> counted;
                (left_for_good(world, next, leaving, counted) ? left : met) += 1;
            }
        }
    }
    EXPECT_GT(left, samples(200));
    EXPECT_GT(met, samples(200));
}

} // namespace
} // namespace rayscope::test
