#include "core/math/box.hpp"
#include "core/math/interval.hpp"
#include "core/math/ray.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

TEST(Interval, is_empty_without_an_inside) {
    EXPECT_FALSE(Interval<double>{}.empty());
    EXPECT_TRUE(Interval<double>::nothing().empty());
    EXPECT_TRUE((Interval<double>{1, 1, 0, 0}.empty()));
    EXPECT_TRUE((Interval<double>{2, 1, 0, 0}.empty()));
    EXPECT_FALSE((Interval<double>{1, 2, 0, 0}.empty()));
    EXPECT_TRUE((Interval<double>{std::numeric_limits<double>::quiet_NaN(), 1, 0, 0}.empty()));
}

TEST(Interval, the_intersection_keeps_the_face_that_made_each_end) {
    const Interval<double> a{1, 4, 10, 11}, b{2, 5, 20, 21}, inner{2, 3, 30, 31};
    const auto expect = [](const Interval<double>& x, double enter, double exit, int enter_face,
                           int exit_face) {
        EXPECT_EQ(x.enter, enter);
        EXPECT_EQ(x.exit, exit);
        EXPECT_EQ(x.enter_face, enter_face);
        EXPECT_EQ(x.exit_face, exit_face);
    };
    expect(intersection(a, b), 2, 4, 20, 11);
    expect(intersection(b, a), 2, 4, 20, 11);
    expect(intersection(a, inner), 2, 3, 30, 31);
    expect(intersection(inner, a), 2, 3, 30, 31);
    expect(intersection(a, {1, 4, 90, 91}), 1, 4, 10, 11); // a tie: the first one's
}

TEST(Range, is_open_at_both_ends) {
    const Range<double> range{1, 2};
    EXPECT_FALSE(range.contains(1));
    EXPECT_TRUE(range.contains(1.5));
    EXPECT_FALSE(range.contains(2));
    EXPECT_FALSE(Range<double>{}.contains(0));
    EXPECT_FALSE(Range<double>{}.contains(-1));
    EXPECT_TRUE(Range<double>{}.contains(5e-324));
    EXPECT_FALSE(Range<double>{}.contains(infinity<double>));
}

TEST(Box, grows_unites_and_intersects) {
    Box<double> box;
    EXPECT_FALSE(box.bounded());
    box.include({1, -2, 3});
    box.include({0, 5, -1});
    EXPECT_EQ(box.low, (Vec3d{0, -2, -1}));
    EXPECT_EQ(box.high, (Vec3d{1, 5, 3}));
    EXPECT_TRUE(box.bounded());
    const Box<double> other{Vec3d{0.5, -9, 2}, Vec3d{2, 0, 9}};
    EXPECT_EQ(united(box, other).low, (Vec3d{0, -9, -1}));
    EXPECT_EQ(united(box, other).high, (Vec3d{2, 5, 9}));
    EXPECT_EQ(intersected(box, other).low, (Vec3d{0.5, -2, 2}));
    EXPECT_EQ(intersected(box, other).high, (Vec3d{1, 0, 3}));
}

TEST(Box, boxes_that_touch_overlap) {
    const Box<double> box{Vec3d{0}, Vec3d{1}};
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vec3d step{0};
            step[axis] = side;
            EXPECT_TRUE(box.overlaps({box.low + step, box.high + step})) << axis << side;
            step[axis] = side * 1.001;
            EXPECT_FALSE(box.overlaps({box.low + step, box.high + step})) << axis << side;
        }
    EXPECT_TRUE(Box<double>::everything().overlaps(box));
    EXPECT_FALSE(Box<double>::everything().bounded());
    EXPECT_FALSE(Box<double>{}.overlaps(box));
}

} // namespace
} // namespace rayscope::test
