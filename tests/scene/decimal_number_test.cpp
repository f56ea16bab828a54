// Numbers in text files: each is rounded once, whatever its form.

#include "core/scene/decimal_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace rayscope::test {
namespace {

TEST(DecimalNumber, is_the_nearest_double_however_it_is_written) {
    for (const char* text : {"0.3", "3e-1", "30e-2", "+0.3", "0.30", ".3", "300E-3", "0.0003e+3"})
        EXPECT_EQ(decimal_number(text), 0.3) << text;
    EXPECT_EQ(decimal_number("12345.6789"), 12345.6789);
    EXPECT_EQ(decimal_number("-7"), -7.0);
}

TEST(DecimalNumber, out_of_range_is_zero_or_infinite) {
    const std::string zeros(400, '0');
    for (const std::string& tiny : {std::string("1e-400"), std::string("123456E-99999999999999999999"),
                                    "0." + zeros + "1", "1" + zeros + "e-800", "." + zeros + "1e+3"})
        EXPECT_EQ(decimal_number(tiny), 0.0) << tiny;
    for (const std::string& huge : {std::string("1e400"), std::string("0.001e99999999999999999999"),
                                    "1" + zeros, "1" + zeros + ".5", "0." + zeros + "1e900"})
        EXPECT_EQ(decimal_number(huge), HUGE_VAL) << huge;
    EXPECT_EQ(decimal_number("-1e400"), -HUGE_VAL);
    EXPECT_TRUE(std::signbit(decimal_number("-1e-400").value()));
}

TEST(DecimalNumber, may_be_infinite_or_none_in_words) {
    EXPECT_EQ(decimal_number("inf"), HUGE_VAL);
    EXPECT_EQ(decimal_number("-inf"), -HUGE_VAL);
    EXPECT_TRUE(std::isnan(decimal_number("nan").value()));
}

TEST(DecimalNumber, is_the_whole_text_or_none) {
    for (const char* text : {"", "+", "-", "+-1", "--1", "1.5x", "1 2", "0x10", "e5", "1,5"})
        EXPECT_EQ(decimal_number(text), std::nullopt) << text;
}

} // namespace
} // namespace rayscope::test
