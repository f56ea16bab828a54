#include "core/accuracy/configuration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace rayscope::test {
namespace {

const Configuration base{{}, 7, 0.02};

Configuration with(ScalarType scalar, Method method) {
    Configuration c = base;
    c.numbers = {scalar, method};
    return c;
}

TEST(Configuration, the_base_comes_first_and_nothing_comes_twice) {
    for (const char* text : {"default", "full", "scalar", "float/float/depth", "double,stable"}) {
        const auto list = configurations(text, base);
        EXPECT_EQ(list.front(), base) << text;
        for (std::size_t i = 0; i < list.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(list[i] == list[j]) << text;
    }
}

TEST(Configuration, values_replace_those_of_the_base) {
    EXPECT_EQ(configuration("float", base), with(ScalarType::float32, Method::stable));
    EXPECT_EQ(configuration("textbook", base), with(ScalarType::float64, Method::textbook));
    EXPECT_EQ(configuration("long double,textbook", base), with(ScalarType::float80, Method::textbook));
    EXPECT_EQ(configuration("scalar=float128", base), with(ScalarType::float128, Method::stable));
    EXPECT_EQ(configuration("depth=0,weight=1", base), (Configuration{{}, 0, 1}));
}

TEST(Configuration, an_axis_alone_changes_nothing_else) {
    for (const Configuration& c : configurations("depth", base)) {
        EXPECT_EQ(c.numbers, base.numbers);
        EXPECT_EQ(c.min_weight, base.min_weight);
    }
    EXPECT_EQ(configurations("scalar", base).size(), 4U);
    EXPECT_EQ(configurations("default", base).size(), 8U + 6 + 4);
}

TEST(Configuration, the_full_product_has_every_combination) {
    EXPECT_EQ(configurations("full", base).size(), 4U * 2 * 7 * 5);
    EXPECT_THAT(configurations("full", base),
                testing::Contains(configuration("float128,textbook,depth=12,weight=0.1", base)));
}

TEST(Configuration, a_wrong_word_is_named_with_what_was_expected) {
    const auto message = [](const char* text) -> std::string {
        try {
            (void)configurations(text, base);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_EQ(message("float/deep"),
              "'deep' is no value of an axis; expected scalar=float, double, 'long double' or "
              "float128; method=stable or textbook; depth=a whole number from 0 to 256; "
              "weight=a number from 0 to 1");
    EXPECT_EQ(message("depth=-1"), "expected a whole number from 0 to 256 after 'depth=', found '-1'");
    EXPECT_EQ(message("weight=nan"), "expected a number from 0 to 1 after 'weight=', found 'nan'");
    for (const char* text : {"", "/", "float,", "depth=", "depth=1e9", "depth=3x", "=", "colour=3", "Float"})
        EXPECT_NE(message(text), "accepted") << text;
}

} // namespace
} // namespace rayscope::test
