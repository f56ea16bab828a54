// Guards against a chart of what effects cost that is empty, and against files that it can't be made of.

#include "tests/support/temporary_folder.hpp"
#include "visualizer/drawing/effects_chart.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

namespace rayscope::drawing {
namespace {

std::filesystem::path written(const test::TemporaryFolder& folder, const std::string& text) {
    const auto path = folder.path() / "effects.json";
    std::ofstream(path) << text;
    return path;
}

std::string message_of(const std::string& text) {
    const test::TemporaryFolder folder;
    try {
        (void)read_effects(written(folder, text));
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

std::string one_effect(const std::string& name, const std::string& called_for, const std::string& median,
                       const std::string& difference) {
    return R"({"effect": ")" + name + R"(", "called_for": )" + called_for + R"(, "time_ratio": {"median": )" +
           median + R"(, "least": 0.9, "greatest": 2.5}, "difference": )" + difference + "}";
}

std::string file_of(const std::string& effects) {
    return R"({"scene": "bowl.toml", "effects": [)" + effects + "]}";
}

int count(const Raster& raster, const Rgb& colour) {
    int found = 0;
    for (std::size_t i = 0; i + 2 < raster.bytes.size(); i += 3)
        found += int(Rgb{raster.bytes[i], raster.bytes[i + 1], raster.bytes[i + 2]} == colour);
    return found;
}

TEST(EffectsChart, has_bars_as_long_as_the_numbers_say) {
    const test::TemporaryFolder folder;
    const EffectsFile file =
        read_effects(written(folder, file_of(one_effect("shadows", "true", "2", "4") + "," +
                                             one_effect("fresnel", "true", "1", "1") + "," +
                                             one_effect("patterns", "false", "1.5", "0"))));
    ASSERT_EQ(file.effects.size(), 3U);
    EXPECT_FALSE(file.effects[2].called_for);
    EffectsFile first = file, second = file;
    first.effects = {file.effects[0]};
    second.effects = {file.effects[0], file.effects[1]};
    constexpr Rgb blue{0x00, 0x72, 0xB2}, orange{0xD5, 0x5E, 0x00};
    const PictureSize size{960, 540};
    const int one = count(draw_effects_chart(first, size), blue),
              two = count(draw_effects_chart(second, size), blue);
    EXPECT_GT(one, 1000);
    EXPECT_GT(two, one + 500); // a difference of 1 beside one of 4
    EXPECT_EQ(count(draw_effects_chart(first, size), orange), 0);
    EXPECT_GT(count(draw_effects_chart(file, size), orange), 50);
}

TEST(EffectsChart, is_not_made_of_what_is_no_measurement) {
    using testing::HasSubstr;
    EXPECT_THAT(message_of("{"), HasSubstr("effects.json"));
    EXPECT_THAT(message_of(file_of("")), HasSubstr("expected at least one effect"));
    EXPECT_THAT(message_of(file_of(one_effect("shadows", "true", "0", "1"))),
                HasSubstr("expected numbers above 0"));
    EXPECT_THAT(message_of(file_of(one_effect("shadows", "true", "1", "-1"))), HasSubstr("not below 0"));
    EXPECT_THAT(message_of(file_of(one_effect("shadows", "7", "1", "1"))), HasSubstr("boolean"));
}

} // namespace
} // namespace rayscope::drawing
