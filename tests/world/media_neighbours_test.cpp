#include "core/world/media.hpp"

#include "tests/support/effort.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <set>

namespace rayscope::test {
namespace {

struct TestBall {
    Vec3d centre;
    double radius;

    [[nodiscard]] MediumExtent extent() const {
        const Vec3d r{radius};
        return {{centre - r, centre + r}, true, largest_component(absolute(centre)) + radius};
    }
};

MediaNeighbours neighbours(const std::vector<TestBall>& balls) {
    std::vector<std::uint32_t> ids;
    std::vector<MediumExtent> extents;
    for (const TestBall& ball : balls) {
        ids.push_back(std::uint32_t(2 * ids.size())); // every other object transmits
        extents.push_back(ball.extent());
    }
    return {ids, extents};
}

std::set<std::uint32_t> near(const MediaNeighbours& media, std::uint32_t object) {
    std::set<std::uint32_t> result;
    media.each_near(object, [&](std::uint32_t other) { result.insert(other); });
    return result;
}

std::vector<MediumExtent> extents_of(const std::vector<Box<double>>& boxes) {
    std::vector<MediumExtent> extents;
    for (const Box<double>& box : boxes) extents.push_back({box});
    return extents;
}

TEST(MediaNeighbours, are_the_boxes_that_overlap) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random(seed);
        std::vector<std::uint32_t> ids;
        std::vector<Box<double>> boxes;
        const int count = 1 + random.below(40);
        for (int i = 0; i < count; ++i) {
            ids.push_back(std::uint32_t(3 * i + random.below(3)));
            const Vec3d low = random.in_cube(3);
            boxes.push_back({low, low + Vec3d{1.5} + random.in_cube(1)});
            if (random.below(15) == 0) boxes.back() = Box<double>::everything();
            if (i > 0 && random.below(5) == 0)
                boxes.back().low.x = boxes[std::size_t(random.below(i))].high.x;
            boxes.back().high.x = std::max(boxes.back().low.x, boxes.back().high.x);
        }
        const MediaNeighbours media(ids, extents_of(boxes));
        for (std::size_t i = 0; i < ids.size(); ++i) {
            std::set<std::uint32_t> expected;
            for (std::size_t j = 0; j < ids.size(); ++j)
                if (j != i && boxes[i].overlaps(boxes[j])) expected.insert(ids[j]);
            ASSERT_EQ(near(media, ids[i]), expected) << "seed " << seed;
        }
        EXPECT_EQ(near(media, 100000).size(), ids.size()); // an opaque one may lie in any
        EXPECT_EQ(media.all().size(), ids.size());
    }
}

// A crowd in one place, and one apart: each of the crowd is near to all the others, however many they are.
TEST(MediaNeighbours, a_crowd_loses_no_neighbour) {
    std::vector<std::uint32_t> ids;
    std::vector<Box<double>> boxes;
    for (std::uint32_t i = 0; i < 300; ++i) {
        ids.push_back(i);
        const double at = i == 77 ? 100 : 0.001 * double(i * 7 % 300);
        boxes.push_back({Vec3d{at}, Vec3d{at + 1}});
    }
    const MediaNeighbours media(ids, extents_of(boxes));
    for (const std::uint32_t id : ids) {
        const auto found = near(media, id);
        EXPECT_FALSE(found.contains(id));
        for (const std::uint32_t other : ids) {
            if (other != id && id != 77 && other != 77) {
                EXPECT_TRUE(found.contains(other)) << id << ' ' << other;
            }
        }
    }
}

TEST(MediaNeighbours, balls_whose_boxes_share_a_corner_are_none_and_balls_that_touch_are) {
    const MediaNeighbours media =
        neighbours({{{0, 0, 0}, 1}, {{1.5, 1.5, 1.5}, 1}, {{-2, 0, 0}, 1}, {{0.1, 0, 0}, 0.2}});
    EXPECT_EQ(near(media, 0), (std::set<std::uint32_t>{4, 6}));
    EXPECT_TRUE(near(media, 2).empty());
}

TEST(MediaNeighbours, a_box_meets_the_corner_of_another_box) {
    const MediaNeighbours media(
        {0, 1}, {{{{-1, -1, -1}, {1, 1, 1}}, true, 1}, {{{0.9, 0.9, 0.9}, {2, 2, 2}}, false, 2}});
    EXPECT_EQ(near(media, 0), (std::set<std::uint32_t>{1}));
}

// Among few and among so many in one place that nobody's neighbours are stored.
TEST(MediaNeighbours, who_holds_a_point_of_a_surface_is_asked_there) {
    std::size_t asked = 0, held = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(300)); ++seed) {
        Random random(seed);
        const double size = random.decade(-3, 3), spread = random.coin() ? 1 : 4;
        std::vector<TestBall> balls;
        for (int i = 0, count = 2 + random.below(random.coin() ? 10 : 150); i < count; ++i)
            balls.push_back({size * random.in_cube(spread), size * random.uniform(0.1, 1)});
        const MediaNeighbours media = neighbours(balls);
        const auto own = std::size_t(random.below(int(balls.size())));
        const Vec3d point = balls[own].centre + balls[own].radius * random.direction();
        std::set<std::uint32_t> found;
        media.each_at(std::uint32_t(2 * own), point, 0x1p-18, 4 * size,
                      [&](std::uint32_t other) { found.insert(other); });
        EXPECT_FALSE(found.contains(std::uint32_t(2 * own)));
        asked += found.size();
        for (std::size_t i = 0; i < balls.size(); ++i) {
            if (i == own || length(point - balls[i].centre) > balls[i].radius) continue;
            ++held;
            EXPECT_TRUE(found.contains(std::uint32_t(2 * i))) << "seed " << seed << " ball " << i;
        }
    }
    EXPECT_GT(held, 0U);
    EXPECT_LT(asked, 3 * held); // a box is twice as large as its ball
}

TEST(MediaNeighbours, a_point_just_outside_of_an_extent_still_asks) {
    const MediaNeighbours media = neighbours({{{0, 0, 0}, 1}, {{1.5, 0, 0}, 0.5}});
    const auto asks = [&](double x) {
        bool asked = false;
        media.each_at(0, {x, 0, 0}, 0x1p-18, 1, [&](std::uint32_t) { asked = true; });
        return asked;
    };
    EXPECT_TRUE(asks(1));
    EXPECT_TRUE(asks(1 - 0x1p-18));
    EXPECT_FALSE(asks(1 - 0x1p-15));
}

} // namespace
} // namespace rayscope::test
