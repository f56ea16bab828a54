// rayscope explain: what the numbers of an effect that is off are, and the files that a measurement leaves.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace rayscope::test {
namespace {

using nlohmann::json;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

TEST(Explain, tells_the_light_of_what_is_off_though_the_scene_calls_for_it) {
    const Outcome whole = run_program({"explain", "mirror_room", "--energy", "--size", "40x30"});
    EXPECT_EQ(whole.code, 0) << whole.err;
    EXPECT_THAT(whole.out, Not(HasSubstr("Off, though")));
    const Outcome off = run_program(
        {"explain", "mirror_room", "--energy", "--size", "40x30", "--effects=-reflection,-shadows"});
    EXPECT_EQ(off.code, 0) << off.err;
    EXPECT_THAT(off.out, HasSubstr("Off, though the scene calls for it\n"));
    EXPECT_THAT(off.out, HasSubstr("reflection   brings ("));
    EXPECT_THAT(off.out, HasSubstr("shadows      takes ("));
}

TEST(Explain, a_measurement_leaves_a_strip_for_each_effect_and_the_numbers) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_program({"explain", "two_spheres", "--cost", "--runs", "5", "--size", "16x12", "-o", "cost"},
                    {folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json effects = json::parse(content_of(folder.path() / "cost" / "effects.json"));
    EXPECT_EQ(effects.at("format"), "rayscope-effects");
    EXPECT_EQ(effects.at("version"), 1);
    std::vector<std::string> names;
    for (const json& effect : effects.at("effects")) {
        names.push_back(effect.at("effect"));
        EXPECT_GT(effect.at("time_ratio").at("median"), 0);
        EXPECT_LE(effect.at("time_ratio").at("least"), effect.at("time_ratio").at("greatest"));
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "cost" / (names.back() + ".png")))
            << names.back();
    }
    EXPECT_THAT(names, Contains("diffuse"));
    for (const json& effect : effects.at("effects"))
        if (effect.at("effect") == "diffuse") {
            EXPECT_TRUE(effect.at("called_for"));
            EXPECT_GT(effect.at("difference"), 1);
            EXPECT_EQ(effect.at("rays").at("eye"), 0);
        }
}

TEST(Explain, asks_for_the_folder_before_it_measures) {
    const Outcome outcome =
        run_program({"explain", "two_spheres", "--cost", "--runs", "1000", "-o", "/dev/null/cost"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err,
                HasSubstr("-o: expected a folder, or a name for a new one, found '/dev/null/cost'"));
}

} // namespace
} // namespace rayscope::test
