// What the code promises about itself, where a compiler would not notice.

#include "tests/architecture/source_text.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <regex>

namespace rayscope::test {
namespace {

/// A number between about 10⁻¹⁹ and 10⁻⁴ written out: tolerances are to be derived from `epsilon` and the operands.
bool has_magic_tolerance(const std::string& code) {
    static const std::regex decimal(R"re((^|[^\w.])\d*\.?\d*[eE]-0*([4-9]|1[0-9])([^0-9]|$))re");
    static const std::regex plain(R"re((^|[^\w.])0?\.000\d*[1-9])re");
    static const std::regex binary(R"re(0[xX][0-9a-fA-F.]+[pP]-(1[4-9]|[2-5][0-9]|6[0-3])([^0-9]|$))re");
    return std::regex_search(code, decimal) || std::regex_search(code, plain) ||
           std::regex_search(code, binary);
}

TEST(Style, core_has_no_magic_tolerances) {
    for (const auto& file : sources_under(source_tree / "core")) {
        const std::string name = file.lexically_relative(source_tree).generic_string();
        if (name.starts_with("core/math/"))
            continue; // constants of proven algorithms, and of rounded decimals
        const auto lines = without_comments(lines_of(file));
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (has_magic_tolerance(without_literals(lines[i])))
                ADD_FAILURE() << name << ":" << i + 1 << ": derive the tolerance: " << lines[i];
    }
}

TEST(Style, a_file_fits_into_300_lines) {
    for (const char* folder : {"core", "visualizer", "bench", "exercises"})
        for (const auto& file : sources_under(source_tree / folder))
            EXPECT_LE(lines_of(file).size(), 300U) << file.lexically_relative(source_tree).generic_string();
}

TEST(Style, magic_tolerances_are_recognised) {
    for (const char* code : {"if (x < 1e-9)", "1e-4", "t > 1.5E-06", "return 2.e-12;", "0x1p-40", "x*1e-19f",
                             "< 0.0001", ".00005", "-1e-7"})
        EXPECT_TRUE(has_magic_tolerance(code)) << code;
    for (const char* code : {"1e-3", "0.001", "1e-300", "1e-40", "0.0031308", "1e9", "value-4", "0x1p-1074",
                             "0x1p-10", "name1e-5", "100.0001", "1e-20"})
        EXPECT_FALSE(has_magic_tolerance(code)) << code;
}

TEST(SourceText, comments_and_literals_are_blanked) {
    const auto lines =
        without_comments({"a // b", "c /* d", "e */ f", "\"// g\" h", "1'000 // i", "'\"' // j"});
    EXPECT_EQ(lines, (std::vector<std::string>{"a     ", "c     ", "     f", "\"// g\" h", "1'000     ",
                                               "'\"'     "}));
    EXPECT_EQ(without_literals("f(\"1e-9\\\"\", 'x', 1'000)"), "f(\"      \", ' ', 1'000)");
}

} // namespace
} // namespace rayscope::test
