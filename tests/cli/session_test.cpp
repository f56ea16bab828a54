// The conversation of rayscope step: moves, stops, looks, files.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "visualizer/cli/session.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Prism : public testing::Test {
protected:
    Prism() : bench(open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml")) {
        const auto [x, y] = *bench.scene.step_pixel;
        session.emplace(bench, trace_pixel(bench, x, y), style);
    }
    std::string say(const std::string& line) {
        const cli::Reply reply = session->reply(line);
        EXPECT_TRUE(reply.ok) << line << ": " << reply.text;
        return reply.text;
    }
    std::string refused(const std::string& line) {
        const cli::Reply reply = session->reply(line);
        EXPECT_FALSE(reply.ok) << line << ": " << reply.text;
        return reply.text;
    }
    [[nodiscard]] std::pair<int, int> at() const {
        const Spot spot = session->walk().cursor().spot();
        return {spot.ray, spot.event};
    }
    using At = std::pair<int, int>;

    const Workbench bench;
    const cli::StepStyle style{cli::Numbers(6), cli::Paint(false)};
    std::optional<cli::Session> session;
};

TEST_F(Prism, moves_by_all_names) {
    say("n");
    EXPECT_EQ(at(), At(1, 0));
    say("next 2");
    EXPECT_EQ(at(), At(3, 0));
    say("rn");
    EXPECT_EQ(at(), At(2, 0));
    say("s");
    EXPECT_EQ(at(), At(2, 1));
    say("reverse-step");
    EXPECT_EQ(at(), At(2, 0));
    say("goto 4.13");
    EXPECT_EQ(at(), At(4, 13));
    say("in");
    EXPECT_EQ(at(), At(5, 0));
    say("reverse-out");
    EXPECT_EQ(at().first, 4);
    const auto before = at();
    say("in");
    say("finish");
    EXPECT_EQ(at().first, 4);
    EXPECT_GT(at(), before);
    say("undo");
    EXPECT_EQ(at(), At(5, 0));
    say("goto end");
    EXPECT_EQ(at().first, 0);
    EXPECT_THAT(say("step"), StartsWith("That was the last of it"));
    say("3");
    EXPECT_EQ(at(), At(3, 0));
    EXPECT_EQ(session->prompt(), "ray 3 of 0-9, shadow, depth 1> ");
    say("step");
    EXPECT_THAT(session->prompt(), HasSubstr(", event 1 of "));
}

TEST_F(Prism, stops_at_breakpoints_and_says_which) {
    EXPECT_EQ(say("b tir"), "Breakpoint 1: tir\n");
    EXPECT_THAT(say("c"),
                AllOf(StartsWith("breakpoint 1: tir\n"), HasSubstr("beyond the critical angle 41.8103°")));
    EXPECT_EQ(at(), At(4, 13));
    EXPECT_EQ(say("p theta_from > critical"), "theta_from > critical = true\n");
    EXPECT_EQ(say("p theta_from"), "theta_from = 48.5102°\n");
    EXPECT_THAT(say("info b"), HasSubstr("stopped 1 time\n"));
    EXPECT_THAT(say("c"), StartsWith("Nothing stops any more"));
    EXPECT_THAT(say("rc"), StartsWith("breakpoint 1: tir"));
    EXPECT_EQ(at(), At(4, 13));
    say("disable 1");
    EXPECT_THAT(say("rc"), StartsWith("Nothing stopped before"));
    say("delete 1");
    EXPECT_THAT(say("info breakpoints"), StartsWith("There are no breakpoints"));
    EXPECT_THAT(say("watch depth"), HasSubstr("Watch 2: depth, now 0"));
    EXPECT_THAT(say("continue"), StartsWith("watch 2: depth: 0 → 1\n"));
    EXPECT_THAT(say("tbreak miss"), HasSubstr("once"));
    say("delete 2");
    say("c");
    EXPECT_THAT(say("info b"), StartsWith("There are no"));
    EXPECT_THAT(say("display weight"), HasSubstr("1: weight = "));
    EXPECT_THAT(say("step"), HasSubstr("1: weight = "));
    say("undisplay 1");
    EXPECT_THAT(say("until depth 0"), HasSubstr("ray 0, eye"));
}

TEST_F(Prism, refuses_what_makes_no_sense) {
    EXPECT_EQ(refused("nxet"), "unknown command 'nxet'; did you mean 'next'?; help lists them\n");
    EXPECT_THAT(refused("reverse"),
                HasSubstr("begins reverse-step, reverse-in, reverse-over, reverse-out or "));
    EXPECT_THAT(refused("next x"), HasSubstr("next: expected a whole number from 1 to 1000000, found 'x'"));
    EXPECT_THAT(refused("goto 99"), HasSubstr("goto: expected a ray from 0 to 9, found '99'"));
    EXPECT_THAT(refused("goto 1.999"), HasSubstr("expected an event from 0 to "));
    EXPECT_THAT(refused("goto -1"), HasSubstr("expected a ray"));
    EXPECT_THAT(refused("goto 1e300"), HasSubstr("expected a ray"));
    EXPECT_EQ(
        refused("break depht > 2"),
        "break: column 1: no field or event is called 'depht'; did you mean 'depth'?\n  depht > 2\n  ^\n");
    EXPECT_THAT(refused("break depth"), HasSubstr("expected a condition, found a value"));
    EXPECT_THAT(refused("break divergence"), HasSubstr("choose it by diff first"));
    EXPECT_THAT(refused("watch"), HasSubstr("expected a condition"));
    EXPECT_THAT(refused("delete 7"), HasSubstr("there is no breakpoint or watch 7"));
    EXPECT_THAT(refused("pixel 9999,0"), HasSubstr("lies outside the image"));
    EXPECT_THAT(refused("find cell 3"), HasSubstr("choose one, such as --stage octree"));
    EXPECT_THAT(refused("why-not cell 123456"), HasSubstr("no cell 123456"));
    EXPECT_THAT(refused("tree now"), HasSubstr("tree takes nothing after it"));
    EXPECT_THAT(refused("source /nonexistent"), HasSubstr("can't read commands from '/nonexistent'"));
    EXPECT_THAT(refused("png x.gif"), HasSubstr("expected .png"));
    EXPECT_THAT(refused("diff nonsense"), StartsWith("diff: "));
    EXPECT_THAT(refused("diff stage cube"), StartsWith("diff: "));
    EXPECT_THAT(refused("spans x"), HasSubstr("expected a finite number"));
    EXPECT_THAT(refused(std::string(100'000, 'n')), HasSubstr("at most 8000 bytes"));
    EXPECT_EQ(at(), At(0, 0));
}

TEST_F(Prism, shows_spans_as_bars_and_what_contains_a_t) {
    const std::string bars = say("spans 5.7");
    EXPECT_THAT(bars, AllOf(HasSubstr("█"), HasSubstr("▼ t = 5.7"), HasSubstr("▲")));
    const auto* hit = session->walk().trace().rays[0].find<BoundaryChosen>();
    const std::string before = say("spans " + std::to_string(hit->boundary.t - 0.001));
    const std::string after = say("spans " + std::to_string(hit->boundary.t + 0.001));
    const auto prism = [](const std::string& text) {
        const auto begin = text.find("\nprism");
        return text.substr(begin, text.find('\n', begin + 1) - begin);
    };
    EXPECT_THAT(prism(before), testing::EndsWith("– "));
    EXPECT_THAT(prism(after), testing::EndsWith(" in"));
}

TEST_F(Prism, draws_the_refraction_card) {
    EXPECT_THAT(say("refraction"), AllOf(HasSubstr("Fresnel      R = "), HasSubstr("R + T = 100 %"),
                                         HasSubstr("Schlick"), HasSubstr("bent towards the normal")));
    say("goto 4");
    EXPECT_THAT(say("ref"), AllOf(HasSubstr("Total internal reflection"), HasSubstr("beyond it"),
                                  HasSubstr("no ray goes there"), HasSubstr("R = 100 %")));
    say("goto 1");
    EXPECT_THAT(say("ref"), HasSubstr("meets no boundary that lets light through"));
}

TEST_F(Prism, finds_and_compares) {
    Scene scene = bench.scene;
    scene.camera.width = scene.camera.height = 24;
    const Workbench small = make_workbench(std::move(scene));
    cli::Session of_small(small, trace_pixel(small, 12, 12), style);
    EXPECT_THAT(of_small.answer("find tir && depth < 1"), HasSubstr("None of 576 pixels has it."));
    EXPECT_THAT(of_small.answer("find spawn && eye"),
                AllOf(HasSubstr("576 of 576 pixels"), HasSubstr("… and 564 more")));
    EXPECT_THAT(say("diff stage octree"),
                AllOf(HasSubstr("No divergence"), Not(HasSubstr("break divergence"))));
    EXPECT_THAT(say("diff depth=1"),
                AllOf(HasSubstr("The first divergence"), HasSubstr("break divergence stops there")));
    say("break divergence");
    EXPECT_THAT(say("c"), StartsWith("breakpoint 1: divergence\n"));
    EXPECT_EQ(at(), At(4, 14)); // where the first of depth 2 would be sent
}

TEST_F(Prism, says_why_a_cell_was_not_looked_into) {
    EXPECT_THAT(say("cells"), HasSubstr("octree: "));
    EXPECT_THAT(say("why-not cell 0"), AllOf(HasSubstr("cell 0: "), HasSubstr("its box: (")));
}

TEST_F(Prism, keeps_score_of_predictions) {
    EXPECT_THAT(say("quiz"), HasSubstr("question 1 of "));
    EXPECT_EQ(session->prompt(), "your answer> ");
    EXPECT_THAT(refused("perhaps"), HasSubstr("expected a number from 1 to 2"));
    EXPECT_THAT(say("2"), AllOf(StartsWith("✗ No: yes. Score: 0 of 1 right."), HasSubstr("question 2 of ")));
    EXPECT_THAT(say("prism"), StartsWith("✓ Right: prism. Score: 1 of 2 right."));
    EXPECT_THAT(say("skip"), StartsWith("It is: "));
    EXPECT_THAT(say("quit"), StartsWith("Score: 1 of 2 right."));
    EXPECT_FALSE(session->ended());
    EXPECT_THAT(session->prompt(), StartsWith("ray "));
}

TEST_F(Prism, every_true_answer_is_right) {
    const auto questions =
        questions_of(session->walk().trace(), session->walk().timeline(), {"prism", "floor", "post"});
    EXPECT_GT(questions.size(), 10U);
    say("quiz");
    std::string last;
    for (const Question& question : questions) last = say(question.choices[question.right]);
    const std::string all = std::to_string(questions.size());
    EXPECT_THAT(last, HasSubstr("That was the last question. Score: " + all + " of " + all + " right."));
}

TEST_F(Prism, saves_what_source_reads) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "session").string();
    say("break tir");
    say("watch depth");
    say("disable 2");
    say("goto 4.3");
    say("save " + file);
    say("delete");
    say("goto 0");
    say("source " + file);
    EXPECT_EQ(at(), At(4, 3));
    EXPECT_EQ(session->walk().stops().all().size(), 2U);
    say("save " + (folder.path() / "trace.json").string());
    EXPECT_TRUE(exists(folder.path() / "trace.json"));
    std::ofstream(folder.path() / "loop") << "source " << (folder.path() / "loop").string() << "\n";
    EXPECT_THAT(refused("source " + (folder.path() / "loop").string()), HasSubstr("more than 8 deep"));
    std::ofstream(folder.path() / "wrong") << "# a comment\n\nnext\nbrek tir\n";
    EXPECT_THAT(refused("source " + (folder.path() / "wrong").string()),
                HasSubstr("wrong:4: unknown command 'brek'; did you mean 'break'?"));
}

TEST_F(Prism, completes_commands_fields_and_names) {
    EXPECT_THAT(session->completions("refr"), testing::ElementsAre("refraction"));
    EXPECT_THAT(session->completions("break the"), testing::Contains("theta_from"));
    EXPECT_THAT(session->completions("break tir && dep"), testing::ElementsAre("depth"));
    EXPECT_THAT(session->completions("why-not pri"), testing::ElementsAre("prism"));
}

TEST_F(Prism, another_pixel_keeps_the_breakpoints) {
    say("break miss");
    say("pixel 10,10");
    EXPECT_EQ(at(), At(0, 0));
    EXPECT_EQ(session->walk().trace().source.x, 10);
    EXPECT_THAT(say("c"), HasSubstr("breakpoint 1: miss"));
}

// --- as a process

std::vector<std::string> stepping(std::vector<std::string> more) {
    std::vector<std::string> arguments{"step", "prism", "--no-png"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

TEST(Script, is_carried_out_to_its_first_error) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "commands").string();
    std::ofstream(file) << "# where is it total?\nbreak tir\ncontinue\n";
    const Outcome well = run_program(stepping({"--script", file}));
    EXPECT_EQ(well.code, 0) << well.err;
    EXPECT_THAT(well.out, AllOf(HasSubstr("depth 0> break tir\nBreakpoint 1: tir"),
                                HasSubstr("beyond the critical angle")));
    std::ofstream(file) << "next\nfoo\nnext\n";
    const Outcome wrong = run_program(stepping({"--script", file}));
    EXPECT_EQ(wrong.code, 2);
    EXPECT_EQ(wrong.err, file + ":2: unknown command 'foo'; help lists them\n");
    const Outcome missing = run_program(stepping({"--script", "nowhere"}));
    EXPECT_EQ(missing.code, 2);
    EXPECT_THAT(missing.err, HasSubstr("--script: can't read 'nowhere'"));
}

TEST(Script, without_end_or_without_text_does_no_harm) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "commands").string();
    std::ofstream(file) << std::string(3'000'000, 'x');
    EXPECT_EQ(run_program(stepping({"--script", file})).code, 2);
    std::ofstream(file) << std::string("next\0\0step\n\xff\xfe\n", 15);
    EXPECT_EQ(run_program(stepping({"--script", file})).code, 2);
    EXPECT_EQ(run_program(stepping({"--script", folder.path().string()})).code, 2);
}

TEST(Script, answers_in_json_line_by_line) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "commands").string();
    std::ofstream(file) << "break tir\nc\nbogus\nn\n";
    const Outcome outcome = run_program(stepping({"--json", "--script", file}));
    EXPECT_EQ(outcome.code, 2); // one line was wrong
    EXPECT_EQ(std::ranges::count(outcome.out, '\n'), 5);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr(R"("command":"continue")"), HasSubstr(R"("expression":"tir")"),
                                   HasSubstr(R"("event":"totally_reflected")"), HasSubstr(R"("ok":false)")));
}

TEST(FindCommand, lists_counts_and_writes_a_mask) {
    const TemporaryFolder folder;
    const Outcome found = run_program(
        {"find", "prism", "--where", "tir && depth >= 3", "--size", "60x60", "-o", "m.png"}, {folder.path()});
    EXPECT_EQ(found.code, 0) << found.err;
    EXPECT_THAT(found.out, AllOf(HasSubstr(" of 3600 pixels"), HasSubstr("first        pixel "),
                                 HasSubstr("mask         m.png")));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"m.png"});
    const Outcome none =
        run_program({"find", "two_spheres", "--where", "tir", "--size", "20x20"}, {folder.path()});
    EXPECT_EQ(none.out, "None of 400 pixels has it.\n");
    const Outcome as_json = run_program(
        {"find", "prism", "--where", "tir", "--size", "20x20", "--json", "--list", "2"}, {folder.path()});
    EXPECT_THAT(as_json.out, AllOf(HasSubstr(R"("width":20)"), HasSubstr(R"("first":{"event":)")));
    for (const char* wrong : {"tri", "depth", "tir &&", "cell 3", ""}) {
        const Outcome refused =
            run_program({"find", "prism", "--where", wrong, "-o", "x.png"}, {folder.path()});
        EXPECT_EQ(refused.code, 2) << wrong;
        EXPECT_THAT(refused.err, HasSubstr("--where: ")) << wrong;
    }
    EXPECT_EQ(folder.names(), std::vector<std::string>{"m.png"});
}

TEST(DiffCommand, tells_an_edited_scene_apart) {
    const TemporaryFolder folder;
    const std::filesystem::path scene = RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml";
    std::string text = content_of(scene);
    std::ofstream(folder.path() / "same.toml") << text;
    const Outcome same = run_program({"diff", scene.string(), "same.toml"}, {folder.path()});
    EXPECT_EQ(same.code, 0) << same.err;
    EXPECT_THAT(same.out, HasSubstr("No divergence"));
    const auto at = text.find("[lights.");
    ASSERT_NE(at, std::string::npos);
    text.insert(at, "[lights.extra]\nposition = [1, 9, 1]\ncolour = 0.2\n\n");
    std::ofstream(folder.path() / "edited.toml") << text;
    const Outcome edited = run_program({"diff", scene.string(), "edited.toml"}, {folder.path()});
    EXPECT_THAT(edited.out, AllOf(HasSubstr("The first divergence"), HasSubstr("the number of lights")));
    EXPECT_EQ(run_program({"diff", scene.string()}).code, 2);
    EXPECT_EQ(run_program({"diff", scene.string(), "--stage", "octree", "--config", "float"}).code, 2);
}

TEST(Terminal, completes_edits_and_remembers) {
    TerminalProgram program(stepping({}));
    program.shown_until("depth 0> ");
    program.type("brea\ttir\n");
    program.shown_until("Breakpoint 1: tir");
    program.shown_until("depth 0> ");
    program.type("c\n");
    program.shown_until("event 13 of 16> ");
    program.type("print weihgt\x7f\x7f\x7f\x7fight\n"); // corrected while typing
    program.shown_until("weight = 0.9\r\n");
    program.shown_until("> ");
    program.type("\x1b[A\x1b[A\n"); // up, up: continue
    program.shown_until("Nothing stops any more");
    program.type("quit\n");
    EXPECT_EQ(program.code(), 0);
}

} // namespace
} // namespace rayscope::test
