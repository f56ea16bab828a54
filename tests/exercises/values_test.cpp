// Values between the grader and the code that it runs: compared with a tolerance, read from any bytes.

#include "exercises/grader/value.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rayscope::test {
namespace {

using namespace exercises;
using exercises::Value; // not rayscope's own

constexpr double inf = std::numeric_limits<double>::infinity(),
                 nan_value = std::numeric_limits<double>::quiet_NaN();

Value spans(double a, double b) { return {List{{Record{"Span", {{"a", {a}}, {"b", {b}}}}}}}; }

TEST(Values, come_back_as_they_went) {
    const Value all{List{{1.5}, {std::int64_t(-3)}, {true}, {std::string("A-B")}, {}, spans(-inf, 2)}};
    const auto back = decoded(encoded(all));
    ASSERT_TRUE(back);
    EXPECT_TRUE(same(*back, all, {0, 0}));
}

TEST(Values, are_the_same_within_the_tolerance) {
    EXPECT_TRUE(same(spans(1, 2), spans(1 + 1e-10, 2), {}));
    EXPECT_FALSE(same(spans(1, 2), spans(1 + 1e-8, 2), {}));
    EXPECT_TRUE(same({1e12}, {1e12 + 100}, {}));
    EXPECT_TRUE(same({-0.0}, {0.0}, {0, 0}));
    EXPECT_FALSE(same({inf}, {1e308}, {0, 1}));
    EXPECT_FALSE(same({inf}, {-inf}, {0, 1}));
    EXPECT_TRUE(same({nan_value}, {nan_value}, {}));
    EXPECT_FALSE(same({nan_value}, {1.0}, {}));
    EXPECT_FALSE(same(spans(1, 2), {List{}}, {}));
    EXPECT_FALSE(same({1.0}, {std::int64_t(1)}, {})); // another type
    EXPECT_FALSE(same({}, {0.0}, {}));
}

TEST(Values, print_as_code) {
    EXPECT_EQ(text_of(spans(-inf, 0.1)), "{{-INF, 0.1}}");
    EXPECT_EQ(text_of({Record{"Hit", {{"t", {1.0}}, {"enter", {true}}}}}), "Hit{1, true}");
    EXPECT_EQ(text_of({std::string("a\"\x1b")}), R"("a\"\x1b")");
    EXPECT_EQ(text_of(Value{}), "nothing");
    EXPECT_LT(text_of({std::string(100000, 'x')}, 6, 100).size(), 110U);
}

TEST(Values, of_any_bytes_are_read_or_refused) {
    Random random(20261125);
    for (int i = 0; i < 20000; ++i) {
        std::string bytes;
        for (int k = random.below(40); k > 0; --k) bytes += "ndibslr\x01\0\xff"[random.below(10)];
        const auto value = decoded(bytes);
        EXPECT_TRUE(!value || decoded(encoded(*value)));
    }
}

} // namespace
} // namespace rayscope::test
