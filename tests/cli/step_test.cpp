// rayscope step: the text, the conversation.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <sstream>

namespace rayscope::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::size_t columns(const std::string& line) {
    return std::size_t(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

TEST(Step, of_the_glass_bowl_prints_what_was_checked_by_hand) {
    const Outcome outcome = run_program({"step", "--no-png"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const std::filesystem::path golden = RAYSCOPE_SOURCE_DIR "/tests/golden/step_glass_bowl.txt";
    const std::string expected = content_of(golden);
    std::istringstream was(expected), is(outcome.out);
    std::string was_line, is_line;
    for (int line = 1; std::getline(was, was_line); ++line) {
        std::getline(is, is_line);
        ASSERT_EQ(is_line, was_line) << golden << ":" << line;
    }
    EXPECT_EQ(outcome.out.size(), expected.size());
}

TEST(Step, fits_into_80_columns) {
    for (const char* scene : {"glass_bowl", "mirror_room", "prism", "two_spheres"}) {
        std::istringstream text(run_program({"step", scene, "--no-png"}).out);
        for (std::string line; std::getline(text, line);)
            EXPECT_LE(columns(line), 80U) << scene << ": " << line;
    }
}

TEST(Step, shows_no_colours_where_no_terminal_is) {
    EXPECT_THAT(run_program({"step", "--no-png"}).out, Not(HasSubstr("\033")));
}

TEST(Step, names_the_sample_and_says_when_no_image_has_it) {
    const Outcome seventh = run_program({"step", "mirror_bowl", "--sample", "7", "--no-png"});
    EXPECT_THAT(seventh.out, HasSubstr("), sample 7\n"));
    EXPECT_EQ(seventh.err, "");
    const Outcome none = run_program({"step", "mirror_bowl", "--sample", "16", "--no-png"});
    EXPECT_EQ(none.code, 0);
    EXPECT_EQ(none.err,
              "rayscope: the scene takes 16 samples of a pixel at most: number 16 is in no image without "
              "larger --samples\n");
    EXPECT_THAT(run_program({"step", "glass_bowl", "--no-png"}).out, Not(HasSubstr("sample")));
}

TEST(Step, a_given_ray_keeps_its_length) {
    const Outcome outcome = run_program({"step", "--ray", "0,0,8,0,0,-2", "--no-png"});
    EXPECT_THAT(outcome.out, HasSubstr("a ray given by hand"));
    EXPECT_THAT(outcome.out, HasSubstr("|d| = 2: t counts lengths of d"));
    EXPECT_THAT(run_program({"step", "--ray", "0,0,8,0,0,-1", "--no-png"}).out, Not(HasSubstr("|d|")));
}

TEST(Step, a_miss_brings_the_background) {
    const Outcome outcome = run_program({"step", "--ray", "0,9,0,0,1,0", "--no-png"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("0 eye misses everything: background"));
    EXPECT_THAT(outcome.out, HasSubstr("(0.55, 0.68, 0.85)"));
    EXPECT_THAT(outcome.out, HasSubstr("100.0 %"));
}

TEST(Step, digits_are_as_many_as_asked_for) {
    EXPECT_THAT(run_program({"step", "--ray", "0.1,9,0,0,1,0", "--no-png", "--digits", "17"}).out,
                HasSubstr("0.10000000000000001"));
    EXPECT_THAT(run_program({"step", "--ray", "0.123456,9,0,0,1,0", "--no-png", "--digits", "2"}).out,
                HasSubstr("(0.12, 9, 0)"));
}

bool can_draw() { return exists(std::filesystem::path(RAYSCOPE_PROGRAM).parent_path() / "rayscope-view"); }

TEST(StepPicture, is_drawn_or_said_to_be_missing) {
    const TemporaryFolder folder;
    const Outcome by_default = run_program({"step", "two_spheres"}, {folder.path()});
    EXPECT_EQ(by_default.code, 0) << by_default.err;
    const Outcome asked_for = run_program({"step", "two_spheres", "--png", "a.png"}, {folder.path()});
    if (can_draw()) {
        EXPECT_THAT(by_default.out, HasSubstr("picture: rayscope-step.png\n"));
        EXPECT_EQ(asked_for.code, 0) << asked_for.err;
        EXPECT_EQ(folder.names(), (std::vector<std::string>{"a.png", "rayscope-step.png"}));
    } else {
        EXPECT_THAT(by_default.err, HasSubstr("no picture: this build can't draw"));
        EXPECT_EQ(asked_for.code, 1);
        EXPECT_THAT(asked_for.err, HasSubstr("this build can't draw: rayscope-view is missing"));
        EXPECT_THAT(folder.names(), testing::IsEmpty());
    }
}

TEST(StepPicture, all_steps_are_pictures_with_numbers) {
    const TemporaryFolder folder;
    const std::vector<std::string> command{"step",  "two_spheres", "--all-steps", "--png",
                                           "a.png", "--size",      "480x320"};
    const Outcome outcome = run_program(command, {folder.path()});
    EXPECT_EQ(outcome.code, can_draw() ? 0 : 1) << outcome.err;
    if (!can_draw()) return;
    EXPECT_THAT(outcome.out, HasSubstr("pictures:\na-0.png\n"));
    EXPECT_GT(folder.names().size(), 1U);
    EXPECT_EQ(folder.names().front(), "a-0.png");
}

TEST(StepPicture, paraview_files_come_from_the_same_program) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program({"trace", "two_spheres", "-o", "a.vtm"}, {folder.path()});
    EXPECT_EQ(outcome.code, can_draw() ? 0 : 1) << outcome.err;
    EXPECT_EQ(exists(folder.path() / "a.vtm"), can_draw());
}

TEST(StepSession, walks_through_the_tree) {
    TerminalProgram program({"step", "glass_bowl", "--no-png"});
    program.shown_until("ray 0 of 0-");
    program.shown_until("eye, depth 0> ");
    program.type("next\n");
    program.shown_until("ray 1 of 0-");
    program.type("\n"); // repeats next
    program.shown_until("ray 2 of 0-");
    program.type("back\n");
    program.shown_until("ray 1 of 0-");
    program.type("out\n");
    program.shown_until("ray 0 of 0-");
    program.type("g 3\n");
    program.shown_until("ray 3 of 0-");
    program.type("tree\n");
    EXPECT_THAT(program.shown_until("ray 3 of 0-"), HasSubstr("◄"));
    program.type("in\n");
    program.shown_until("> ");
    program.type("over\n");
    program.shown_until("> ");
    program.type("nxet\n");
    program.shown_until("did you mean 'next'?");
    program.type("goto 12345\n");
    program.shown_until("goto: expected a ray from 0 to ");
    program.type("quit\n");
    EXPECT_EQ(program.code(), 0);
}

TEST(StepSession, ends_with_the_input) {
    TerminalProgram program({"step", "glass_bowl", "--no-png"});
    program.shown_until("depth 0> ");
    EXPECT_EQ(program.code("\x15\x04"), 0);
}

TEST(StepSession, has_colours_unless_they_are_not_wanted) {
    TerminalProgram coloured({"step", "glass_bowl", "--no-png"});
    EXPECT_THAT(coloured.shown_until("depth 0> "), HasSubstr("\033[38;5;166m"));
    TerminalProgram plain({"step", "glass_bowl", "--no-png"}, {RAYSCOPE_SOURCE_DIR, {"NO_COLOR=1"}});
    EXPECT_THAT(plain.shown_until("Where it comes from"), Not(HasSubstr("\033[")));
}

} // namespace
} // namespace rayscope::test
