// Guards against a stage that loses a hit: every stage gives the scan's answers, bit for bit.

#include "core/bvh/bvh.hpp"
#include "core/extents/extents.hpp"
#include "core/extents/scan.hpp"
#include "core/octree/octree.hpp"
#include "core/scene/build.hpp"
#include "core/tracer/interaction.hpp"
#include "tests/agreement/random_scene.hpp"
#include "tests/agreement/same_answers.hpp"
#include "tests/support/effort.hpp"

namespace rayscope::test {
namespace {

template <typename Stage>
void expect_scans_answers(const World<double>& world, const Scan<double>& scan, const Stage& stage,
                          const Ray<double>& ray, double reach, const Leaving<double>& leaving,
                          const std::string& what) {
    const Answers expected = answers(world, scan, ray, reach, leaving),
                  found = answers(world, stage, ray, reach, leaving);
    ASSERT_TRUE(found == expected) << what << ' ' << hex(ray) << " reach " << hex(reach)
                                   << "\n  scan:  " << described(expected)
                                   << "\n  stage: " << described(found);
}

// A ray of its own, and one that leaves what it hits.
template <typename Stage>
void compare(const World<double>& world, const Scan<double>& scan, const Stage& stage, const Ray<double>& ray,
             Random& random, const std::string& what) {
    const double reach = random.coin() ? infinity<double> : random.decade(-2, 2);
    expect_scans_answers(world, scan, stage, ray, reach, {}, what);
    if (testing::Test::HasFatalFailure()) return;
    Work<double> work;
    NullRecorder recorder;
    const Leaving<double> nothing;
    const auto hit = scan.closest(ray, Range<double>{0}, nothing, work, recorder);
    if (!hit) return;
    const auto at = interact(world, ray, hit, nothing, none, work);
    const Ray<double> next{at.point, random.direction()};
    const bool stays = dot(next.direction, at.facing) > 0;
    expect_scans_answers(world, scan, stage, next, reach, stays ? at.back : at.through, what + " leaving");
}

// Coordinates on which a tree is likely to cut, and others that have gone wrong before.
double nasty(Random& random, const Box<double>& box, int axis) {
    const double low = box.low[axis], size = box.high[axis] - low;
    switch (random.below(6)) {
    case 0: return low + size * double(random.below(9)) / 8;
    case 1: return low + size * double(random.below(65)) / 64 + size * 0x1p-52 * (random.below(3) - 1);
    case 2: return 0.0;
    case 3: return random.coin() ? -0.0 : 5e-324;
    case 4: return low - size;
    default: return low + random.uniform(-0.5, 1.5) * size;
    }
}

Ray<double> nasty_ray(Random& random, const Box<double>& box) {
    Ray<double> ray;
    for (int axis = 0; axis < 3; ++axis) ray.origin[axis] = nasty(random, box, axis);
    do {
        for (int axis = 0; axis < 3; ++axis) {
            const double values[] = {0.0, -0.0, 1.0, -1.0, 5e-324, -1e-300, 1e-17, random.uniform(-1, 1)};
            ray.direction[axis] = values[random.below(8)];
        }
    } while (!(length(ray.direction) > 0.5));
    ray.direction = normalized(ray.direction);
    return ray;
}

Box<double> bounds_of(const World<double>& world) {
    Box<double> box;
    for (const Object& object : world.objects)
        if (object.bounds.bounded()) box = united(box, object.bounds);
    return box;
}

template <typename Stage> void compare_on_random_scenes(int scenes, int rays) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(scenes); ++seed) {
        Random random(seed);
        const Scene scene = random_scene(random, 1 + random.below(200));
        const auto world = build(scene);
        const Scan<double> scan(world);
        const Stage stage(world);
        const Box<double> box = bounds_of(world);
        for (int i = 0; i < rays; ++i) {
            Ray<double> ray = nasty_ray(random, box);
            if (random.below(3) != 0) {
                const double half = largest_coordinate(box);
                ray.origin = random.in_cube(half * (random.below(8) == 0 ? random.decade(0, 6) : 1.5));
                ray.direction = normalized(random.in_cube(half) - ray.origin);
            }
            compare(world, scan, stage, ray, random, "seed " + std::to_string(seed));
            if (testing::Test::HasFatalFailure()) return;
        }
    }
}

template <typename Stage> class Agreement : public testing::Test {};
template <typename Stage> class AgreementFull : public testing::Test {};
using Stages = testing::Types<Extents<double>, Octree<double>, Bvh<double>>;
TYPED_TEST_SUITE(Agreement, Stages);
TYPED_TEST_SUITE(AgreementFull, Stages);

TYPED_TEST(Agreement, on_random_scenes_of_all_generics) {
    compare_on_random_scenes<TypeParam>(samples(60), 500);
}
TYPED_TEST(AgreementFull, on_random_scenes_of_all_generics) {
    compare_on_random_scenes<TypeParam>(samples(500), 2000);
}

} // namespace
} // namespace rayscope::test
