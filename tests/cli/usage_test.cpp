// Exit codes and messages: what was wrong, what was expected, and nothing written.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

struct Mistake {
    std::vector<std::string> arguments;
    std::string message;
};

TEST(Usage, mistakes_are_named_with_what_was_expected) {
    const std::vector<Mistake> mistakes{
        {{},
         "rayscope: no command; expected step, find, diff, trace, render, explain, extents, export, "
         "accuracy, "
         "view or help"},
        {{""},
         "rayscope: no command; expected step, find, diff, trace, render, explain, extents, export, "
         "accuracy, "
         "view or help"},
        {{"stp"},
         "rayscope: unknown command 'stp'; did you mean 'step'?; expected step, find, diff, trace, render, "
         "explain, extents, export, accuracy, view or help"},
        {{"help", "stp"}, "rayscope: unknown command 'stp'; did you mean 'step'?"},
        {{"help", "step", "trace"}, "rayscope: unexpected argument 'trace'"},
        {{"--version", "step"}, "rayscope: unexpected argument 'step'"},
        {{"--help=5"}, "rayscope: unknown option '--help=5'; did you mean '--help'?"},
        {{"step", "--no-png=maybe"}, "rayscope: --no-png takes no value"},
        {{"--versoin"}, "rayscope: unknown option '--versoin'; did you mean '--version'?"},
        {{"step", "trace"}, "rayscope: no scene file 'trace'"},
        {{"step", "--pixel"}, "rayscope: --pixel: expected a value after it, found none"},
        {{"step", "--pixel", "1,2", "--pixel", "1,2"}, "rayscope: --pixel is given twice"},
        {{"render", "lens", "-o", "a.png", "-o", "b.png"}, "rayscope: -o is given twice"},
        {{"step", ""}, "rayscope: expected a scene file (.toml, .nff), or the name of a scene"},
        {{"render", "", "-o", "a.png"}, "rayscope: expected a scene file"},
        {{"step", "--pixel", ""}, "rayscope: --pixel: expected X,Y: column and row"},
        {{"step", "--ray", ""}, "rayscope: --ray: expected six finite numbers"},
        {{"step", "--digits", ""}, "rayscope: --digits: expected a whole number from 1 to 17, found ''"},
        {{"step", "--png", ""}, "rayscope: --png: no extension in '', expected .png"},
        {{"step", "--size", ""}, "rayscope: --size: expected WIDTHxHEIGHT in pixels"},
        {{"step", "--why", ""}, "rayscope: expected the name of a drawn object"},
        {{"trace", "-o", ""}, "rayscope: -o: no extension in '', expected .json, .html, .webp or .vtm"},
        {{"render", "lens", "-o", ""}, "rayscope: -o: no extension in '', expected .png, .pfm or .exr"},
        {{"render", "lens", "-o", "a.png", "--threads", ""}, "rayscope: --threads: expected a whole number"},
        {{"render", "lens", "-o", "a.png", "--size", ""}, "rayscope: --size: expected WIDTHxHEIGHT"},
        {{"render", "lens", "-o", "a.png", "--stats", ""},
         "rayscope: --stats: no extension in '', expected .json"},
        {{"step", "--pixl", "1,2"}, "rayscope: unknown option '--pixl'; did you mean '--pixel'?"},
        {{"step", "glass_bowl", "lens"}, "rayscope: unexpected argument 'lens'"},
        {{"step", "glas_bowl"}, "rayscope: no scene file 'glas_bowl'; did you mean 'glass_bowl'?"},
        {{"step", "qqqqqqqqqqqq"}, "rayscope: no scene file 'qqqqqqqqqqqq'; scenes that ship: "},
        {{"step", "README.md"}, "rayscope: no scene file"},
        {{"step", "--pixel", "1;2"}, "rayscope: --pixel: expected X,Y: column and row"},
        {{"step", "--pixel", "-1,2"}, "rayscope: --pixel: expected X,Y"},
        {{"step", "--pixel", "1,2,3"}, "rayscope: --pixel: expected X,Y"},
        {{"step", "--pixel", "640,0"},
         "rayscope: --pixel 640,0 lies outside the image of 640 × 480 pixels, whose last one is 639,479"},
        {{"step", "--pixel", "99999999999,0"}, "rayscope: --pixel: expected X,Y"},
        {{"step", "--ray", "0,0,5,0,0"}, "rayscope: --ray: expected six finite numbers"},
        {{"step", "--ray", "0,0,5,0,0,nan"}, "rayscope: --ray: expected six finite numbers"},
        {{"step", "--ray", "0,0,5,0,0,1e999"}, "rayscope: --ray: expected six finite numbers"},
        {{"step", "--ray", "0,0,5,0,0,0"}, "rayscope: --ray: the direction is 0,0,0"},
        {{"step", "--ray", "0,0,5,0,0,-1", "--pixel", "1,1"},
         "rayscope: --pixel and --ray exclude each other"},
        {{"step", "--digits", "18"}, "rayscope: --digits: expected a whole number from 1 to 17, found '18'"},
        {{"step", "--png"}, "rayscope: --png"},
        {{"step", "--png", "a.jpg"}, "rayscope: --png: unknown extension '.jpg' in 'a.jpg', expected .png"},
        {{"step", "--png", "a.png", "--no-png"}, "rayscope: --png and --no-png exclude each other"},
        {{"trace"}, "rayscope: trace needs to know where to write: -o ray.json"},
        {{"trace", "-o", "a.png"},
         "rayscope: -o: unknown extension '.png' in 'a.png', expected .json, .html, .webp or .vtm"},
        {{"trace", "-o", "a"}, "rayscope: -o: no extension in 'a', expected .json, .html, .webp or .vtm"},
        {{"trace", "-o", "no/a.json"}, "rayscope: -o: can't write no/a.json: its folder does not exist"},
        {{"render"}, "rayscope: render needs a scene"},
        {{"render", "lens"}, "rayscope: render needs to know where to write: -o image.png"},
        {{"render", "lens", "-o", "a.pgn"}, "did you mean '.png'?"},
        {{"render", "lens", "-o", "a.png", "--size", "0x5"},
         "rayscope: --size: expected WIDTHxHEIGHT in pixels"},
        {{"render", "lens", "-o", "a.png", "--size", "640"},
         "rayscope: --size: expected WIDTHxHEIGHT in pixels"},
        {{"render", "lens", "-o", "a.png", "--size", "32769x1"}, "rayscope: --size: expected WIDTHxHEIGHT"},
        {{"render", "lens", "-o", "a.png", "--size", "20000x20000"},
         "rayscope: --size: expected at most 10⁸"},
        {{"render", "lens", "-o", "a.png", "--threads", "0"},
         "rayscope: --threads: expected a whole number from 1"},
        {{"render", "lens", "-o", "a.png", "--stats", "no/a.json"},
         "rayscope: --stats: can't write no/a.json"},
    };
    const TemporaryFolder folder;
    for (const Mistake& mistake : mistakes) {
        std::string line;
        for (const std::string& argument : mistake.arguments) line += argument + " ";
        const Outcome outcome = run_program(mistake.arguments, {folder.path()});
        EXPECT_EQ(outcome.code, 2) << line;
        EXPECT_THAT(outcome.err, HasSubstr(mistake.message)) << line;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_THAT(outcome.out, IsEmpty()) << line;
        EXPECT_THAT(folder.names(), IsEmpty()) << line;
    }
}

TEST(Usage, a_wrong_scene_is_named_with_file_line_and_column) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "bad.toml") << "[camera]\neye = [0, 0, 5]\neyee = 1\n";
    for (const std::vector<std::string>& command : {std::vector<std::string>{"step", "bad.toml"},
                                                    {"render", "bad.toml", "-o", "a.png"},
                                                    {"trace", "bad.toml", "-o", "a.json"}}) {
        const Outcome outcome = run_program(command, {folder.path()});
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.err, StartsWith("bad.toml:3:1: "));
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"bad.toml"});
}

TEST(Usage, help_is_a_command_too) {
    const auto text = [](const std::vector<std::string>& arguments) {
        const Outcome outcome = run_program(arguments);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_EQ(text({"help"}), text({"--help"}));
    for (const char* command : {"step", "trace", "render", "export"}) {
        EXPECT_EQ(text({"help", command}), text({command, "--help"}));
        EXPECT_THAT(text({"help", command}), HasSubstr(std::string("rayscope ") + command + " [OPTIONS]"));
    }
}

TEST(Usage, the_version_is_told) {
    const Outcome outcome = run_program({"--version"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, testing::MatchesRegex("rayscope [0-9]+\\.[0-9]+(\\.[0-9]+)?\n"));
}

TEST(Usage, a_folder_does_not_hide_a_shipped_scene) {
    const TemporaryFolder folder;
    create_directory(folder.path() / "lens");
    const Outcome outcome = run_program({"render", "lens", "-o", "x.png", "--size", "8x6"}, {folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(folder.names(), (std::vector<std::string>{"lens", "x.png"}));
    create_directory(folder.path() / "lens.toml");
    EXPECT_THAT(run_program({"step", "lens.toml", "--no-png"}, {folder.path()}).err, StartsWith("lens.toml"));
}

TEST(Usage, names_of_files_do_not_steer_the_terminal) {
    const TemporaryFolder folder;
    const std::string scene = "s\xFF\x1B\u009B\u202E.toml";
    copy_file(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/two_spheres.toml", folder.path() / scene);
    const auto expect_clean = [](const std::string& text, const std::string& part) {
        EXPECT_THAT(text, HasSubstr(part));
        for (const char* forbidden : {"\xFF", "\x1B", "\u009B", "\u202E"})
            EXPECT_THAT(text, testing::Not(HasSubstr(forbidden)));
    };
    const Outcome step = run_program({"step", scene, "--no-png"}, {folder.path()});
    EXPECT_EQ(step.code, 0) << step.err;
    expect_clean(step.out, "s????.toml, pixel (240, 240)");
    const Outcome trace = run_program({"trace", scene, "-o", "t\xFF.json"}, {folder.path()});
    EXPECT_EQ(trace.code, 0) << trace.err;
    expect_clean(trace.out, "t?.json\n");
    EXPECT_THAT(content_of(folder.path() / "t\xFF.json"), HasSubstr("s\uFFFD"));
    const Outcome render =
        run_program({"render", scene, "-o", "i\x1B\xFF.png", "--size", "8x6"}, {folder.path()});
    EXPECT_EQ(render.code, 0) << render.err;
    expect_clean(render.out, "\ni??.png\n");
    expect_clean(run_program({"step", "no\x1B\xFF.toml"}).err, "no??.toml");
    expect_clean(run_program({"render", "lens", "-o", "no\x1B\xFF/a.png"}).err, "can't write no?"
                                                                                "?/a.png");
}

TEST(Usage, every_help_has_an_example) {
    for (const std::vector<std::string>& command :
         {std::vector<std::string>{"--help"}, {"step", "--help"}, {"trace", "--help"}, {"render", "-h"}}) {
        const Outcome outcome = run_program(command);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_THAT(outcome.out, HasSubstr("Example:\n  rayscope "));
        EXPECT_THAT(outcome.err, IsEmpty());
    }
}

TEST(Usage, the_examples_work) {
    const TemporaryFolder folder;
    EXPECT_EQ(run_program({"step", "glass_bowl", "--pixel", "235,250", "--digits", "4", "--no-png"}).code, 0);
    EXPECT_EQ(
        run_program({"trace", "glass_bowl", "--ray", "0,0.2,5,0,0,-1", "-o", "ray.json"}, {folder.path()})
            .code,
        0);
    EXPECT_EQ(folder.names(), std::vector<std::string>{"ray.json"});
}

TEST(Usage, scenes_are_found_where_the_environment_says) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "mine.toml") << "";
    EXPECT_THAT(run_program({"step", "min", "--no-png"},
                            {folder.path(), {"RAYSCOPE_SCENES=" + folder.path().string()}})
                    .err,
                HasSubstr("did you mean 'mine'?"));
}

} // namespace
} // namespace rayscope::test
