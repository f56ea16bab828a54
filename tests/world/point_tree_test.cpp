#include "core/boxes/point_tree.hpp"

#include "tests/support/effort.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rayscope::test {
namespace {

bool holds(const Box<double>& box, const Vec3d& point, double margin) {
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < box.low[axis] - margin || point[axis] > box.high[axis] + margin) return false;
    return true;
}

TEST(PointTree, finds_every_box_that_holds_a_point_and_few_others) {
    std::size_t others = 0, held = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(300)); ++seed) {
        Random random(seed);
        const double size = random.decade(-6, 6);
        std::vector<Box<double>> boxes;
        for (int i = 0, count = random.below(200); i < count; ++i) {
            const Vec3d low = size * random.in_cube(1);
            boxes.push_back({low, low + size * Vec3d{random.uniform(0, 0.5), 0, random.uniform(0, 1)}});
            if (random.coin()) boxes.back().high.y += size * random.uniform(0, 1);
            if (random.below(40) == 0) boxes.back().low.y = -infinity<double>;
        }
        const PointTree tree(boxes);
        for (int i = 0; i < 20; ++i) {
            Vec3d point = size * random.in_cube(1.2);
            // On the edge of a box, or a float's rounding beside it.
            if (!boxes.empty() && random.coin())
                point = boxes[std::size_t(random.below(int(boxes.size())))].high;
            const double margin = random.coin() ? 0 : size * random.decade(-9, -1);
            std::multiset<std::uint32_t> found;
            tree.each_at(point, margin, [&](std::uint32_t index) { found.insert(index); });
            for (std::uint32_t box = 0; box < boxes.size(); ++box) {
                if (holds(boxes[box], point, margin)) {
                    ++held;
                    ASSERT_EQ(found.count(box), 1U) << "seed " << seed << " box " << box;
                } else if (boxes[box].bounded()) {
                    others += found.count(box);
                    ASSERT_TRUE(found.count(box) == 0 || holds(boxes[box], point, margin + 0x1p-20 * size))
                        << "seed " << seed << " box " << box;
                }
            }
        }
    }
    EXPECT_GT(held, std::size_t(samples(300)));
    EXPECT_LT(others, held / 100);
}

TEST(PointTree, of_nothing_finds_nothing) {
    PointTree().each_at({0, 0, 0}, 1, [](std::uint32_t) { FAIL(); });
    PointTree(std::vector<Box<double>>{}).each_at({0, 0, 0}, 1, [](std::uint32_t) { FAIL(); });
}

} // namespace
} // namespace rayscope::test
