// rayscope step --compare: where two runs of one ray part.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "visualizer/cli/session.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace rayscope::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string compared(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "step");
    const TemporaryFolder folder;
    const Outcome outcome = run_program(arguments, {folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(folder.names(), IsEmpty()); // no picture
    return outcome.out;
}

TEST(Compare, FindsWhereTheSchoolbookLosesADistance) {
    const std::string text = compared({"far_tiny_sphere", "--compare", "float,textbook"});
    EXPECT_THAT(text,
                AllOf(HasSubstr("A            double stable, depth 8, weight 0.001: the scene's own\n"),
                      HasSubstr("B            float textbook, depth 8, weight 0.001\n"),
                      HasSubstr("── The first divergence ──"), HasSubstr("ray          0, eye, depth 0\n"),
                      HasSubstr("asked        t of the hit\n"), HasSubstr("A            2999.19\n"),
                      HasSubstr("B            2999\n"), HasSubstr("777 ulps of float")));
}

TEST(Compare, FindsTheShadowThatASurfaceCastsOnItself) {
    EXPECT_THAT(compared({"grazing_light", "--compare", "float,textbook"}),
                AllOf(HasSubstr("ray          1, shadow, depth 0"), HasSubstr("what is seen of light sun"),
                      HasSubstr("A            1\n"),
                      HasSubstr("B            0: ball is in the way, at t = 0.0001")));
}

TEST(Compare, FindsTheSurfaceThatAConstantSkips) {
    for (const char* numbers : {"float,textbook", "textbook"})
        EXPECT_THAT(compared({"nested_glass", "--compare", numbers}),
                    AllOf(HasSubstr("ray          3, refracted, depth 1"), HasSubstr("which object is hit"),
                          HasSubstr("A            enters filling, face 0, at t = 5e-05"),
                          HasSubstr("B            enters inner_shell, face 0, at t = 0.0004")));
}

TEST(Compare, FindsNothingWhereTheStableFormulasStand) {
    for (const char* scene :
         {"far_tiny_sphere", "grazing_light", "nested_glass", "flush_holes", "glass_bowl"})
        for (const char* numbers : {"float", "long double", "float128"})
            EXPECT_THAT(compared({scene, "--compare", numbers}),
                        AllOf(HasSubstr("── No divergence ──"), Not(HasSubstr("first divergence")),
                              HasSubstr("The largest difference in ulps"), ContainsRegex("[0-9] ulps of ")))
                << scene << " " << numbers;
}

TEST(Compare, TheSameNumbersAgreeBitForBit) {
    EXPECT_THAT(compared({"mirror_room", "--compare", "double,stable"}),
                AllOf(HasSubstr("8 rays in both runs"), HasSubstr("None: every number is the same"),
                      HasSubstr("the same in a PNG")));
}

TEST(Compare, LimitsAreComparedToo) {
    EXPECT_THAT(compared({"mirror_room", "--compare", "depth=1"}),
                AllOf(HasSubstr("whether a reflected ray follows"), HasSubstr("A            followed\n"),
                      HasSubstr("B            not followed: max_depth is reached, weight ")));
    EXPECT_THAT(compared({"mirror_room", "--compare", "depth=256,weight=0"}),
                HasSubstr("B            followed\n"));
}

TEST(Compare, TakesPixelsRaysAndDigits) {
    EXPECT_THAT(compared({"two_spheres", "--pixel", "0,0", "--compare", "float"}),
                AllOf(HasSubstr("pixel (0, 0)"), HasSubstr("1 ray in both runs")));
    EXPECT_THAT(compared({"far_tiny_sphere", "--compare", "textbook,float", "--digits", "12"}),
                HasSubstr("A            2999.1896"));
    // t counts lengths of the direction, whatever its length.
    for (const char* ray : {"0,0,5,0,0,-3", "0,0,5,0,0,-1e30", "0,0,5,0,0,-1e-200", "1e-50,0,5,0,0,-1"})
        EXPECT_THAT(compared({"two_spheres", "--ray", ray, "--compare", "float"}), HasSubstr("No divergence"))
            << ray;
    EXPECT_THAT(compared({"two_spheres", "--ray", "0,0,1e300,0,0,-1", "--compare", "float"}),
                AllOf(HasSubstr("the ray's origin"), HasSubstr("(0, 0, ∞)")));
}

TEST(Compare, FitsIntoEightyColumns) {
    for (const char* scene : {"nested_glass", "grazing_light", "far_translation", "glass_bowl"}) {
        std::istringstream text(compared({scene, "--compare", "float,textbook"}));
        for (std::string line; std::getline(text, line);)
            EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }), 80)
                << line;
    }
}

TEST(Compare, MistakesAreNamed) {
    const auto message = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "step");
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.out, IsEmpty());
        return outcome.err;
    };
    EXPECT_THAT(message({"--compare"}), HasSubstr("--compare: expected a value after it"));
    EXPECT_THAT(message({"--compare", "half"}),
                HasSubstr("rayscope: --compare: 'half' is no value of an axis"));
    EXPECT_THAT(message({"--compare", ""}), HasSubstr("rayscope: --compare: '' is no value of an axis"));
    EXPECT_THAT(message({"--compare", "depth=300"}),
                HasSubstr("--compare: expected a whole number from 0 to 256"));
    EXPECT_THAT(message({"--compare", "float", "--why", "bowl"}),
                HasSubstr("--compare and --why exclude each other"));
    EXPECT_THAT(message({"--compare", "float", "--png", "a.png"}), HasSubstr("--compare draws no picture"));
    EXPECT_THAT(message({"--compare", "float", "--size", "9x9"}), HasSubstr("--compare draws no picture"));
}

TEST(Compare, ASessionComparesItsRay) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/07_accuracy/grazing_light.toml");
    const cli::StepStyle style{cli::Numbers(6), cli::Paint(false)};
    const Trace pixel = trace_pixel(bench, 512, 512);
    cli::Session session(bench, pixel, style);
    EXPECT_THAT(session.answer("compare float,textbook"), HasSubstr("what is seen of light sun"));
    EXPECT_THAT(session.answer("compare"), HasSubstr("diff: expected numbers or limits"));
    EXPECT_THAT(session.answer("compare half"), HasSubstr("diff: 'half' is no value of an axis"));
    const Trace given = trace_ray(bench, {{0, 6, 160}, {0, 0, -2}});
    EXPECT_THAT(cli::Session(bench, given, style).answer("compare double"),
                HasSubstr("None: every number is the same"));
}

} // namespace
} // namespace rayscope::test
