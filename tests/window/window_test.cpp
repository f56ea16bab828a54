// The window, driven by its widgets, and what it shows.

#include "tests/window/screen.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <sstream>
#include <thread>

namespace rayscope::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;

const std::string scenes = RAYSCOPE_SOURCE_DIR "/chapters/";

/// The answers of the terminal to the same moves.
std::vector<json> terminal_states(const std::string& scene, const std::vector<std::string>& moves) {
    const TemporaryFolder folder;
    std::ofstream file(folder.path() / "moves");
    for (const std::string& move : moves) file << move << '\n';
    file.close();
    const Outcome outcome =
        run_program({"step", scene, "--json", "--script", (folder.path() / "moves").string()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    std::vector<json> states;
    std::istringstream out(outcome.out);
    for (std::string line; std::getline(out, line);)
        if (const json answer = json::parse(line); answer.contains("state"))
            states.push_back(answer["state"]);
    if (!states.empty()) states.erase(states.begin()); // where it stands before the first line
    return states;
}

/// The image is shown smaller than it is: a place on the screen is one of a few pixels.
bool is_near(const json& pixel, int x, int y) {
    return std::abs(pixel.at(0).get<int>() - x) <= 2 && std::abs(pixel.at(1).get<int>() - y) <= 2;
}

TEST_F(Window, what_find_finds_is_an_overlay_until_the_scene_changes) {
    const Reports reports = run_window(screen, "prism",
                                       "type find tir && depth >= 3\n"
                                       "pick 10 10\n"
                                       "heat 0\n"
                                       "heat " +
                                           std::to_string(heat_names.size() + 1) +
                                           "\n"
                                           "type find depth > 200\n"
                                           "open bubble\n");
    const auto shown = [&](std::size_t i) { return reports.lines.at(i).at("found_shown").get<int>(); };
    ASSERT_EQ(reports.lines.size(), 6U) << reports.outcome.err;
    EXPECT_GT(shown(0), 0);
    EXPECT_EQ(shown(1), shown(0)) << "another pixel's ray";
    EXPECT_EQ(shown(2), 0) << "the image as it is";
    EXPECT_EQ(shown(3), shown(0)) << "and back";
    EXPECT_EQ(shown(4), 0) << "nothing was found";
    EXPECT_EQ(shown(5), 0);
}

TEST_F(Window, keys_move_as_the_terminal_does_and_every_number_is_the_same) {
    const std::vector<std::pair<std::string, std::string>> moves{{"N", "next"},
                                                                 {"S", "step"},
                                                                 {"S", "step"},
                                                                 {"Shift+S", "reverse-step"},
                                                                 {"I", "in"},
                                                                 {"O", "over"},
                                                                 {"U", "out"},
                                                                 {"Shift+U", "reverse-out"},
                                                                 {"Shift+N", "back"},
                                                                 {"End", "goto end"},
                                                                 {"Shift+O", "reverse-over"},
                                                                 {"Home", "goto start"},
                                                                 {"Backspace", "undo"}};
    std::string script = "stop tir\n";
    std::vector<std::string> lines{"break tir"};
    for (const auto& [key, line] : moves) {
        script += "key " + key + "\n";
        lines.push_back(line);
    }
    for (const auto& [key, line] :
         {std::pair("Home", "goto start"), {"C", "continue"}, {"Shift+C", "reverse-continue"}}) {
        script += std::string("key ") + key + "\n";
        lines.emplace_back(line);
    }
    const Reports window = run_window(screen, "prism", script);
    const std::vector<json> terminal = terminal_states("prism", lines);
    ASSERT_EQ(window.lines.size(), lines.size()) << window.outcome.err;
    ASSERT_EQ(terminal.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
        EXPECT_TRUE(window.lines[i]["ok"]) << lines[i];
        EXPECT_EQ(window.lines[i]["state"], terminal[i]) << lines[i];
        // The tree's row and the text beside it tell of the same ray.
        const std::string ray = std::to_string(terminal[i]["ray"].get<int>());
        EXPECT_THAT(window.lines[i]["row"][0].get<std::string>(), testing::StartsWith(ray + " ")) << lines[i];
        EXPECT_THAT(window.lines[i]["place"].get<std::string>(), HasSubstr("ray " + ray + " of")) << lines[i];
    }
    EXPECT_EQ(window.outcome.code, 0) << window.outcome.err;
}

TEST_F(Window, a_click_anywhere_selects_everywhere) {
    const Reports window = run_window(
        screen, "glass_bowl", "wait\npick 320 240\nwait\nrow 2\nray 0\nsweep 0.5\nscrub 300 200 310 220\n");
    ASSERT_EQ(window.lines.size(), 7U) << window.outcome.err;
    const auto& lines = window.lines;
    EXPECT_TRUE(is_near(lines[1]["pixel"], 320, 240)) << lines[1]["pixel"];
    EXPECT_EQ(lines[1]["state"]["ray"], 0);
    EXPECT_EQ(lines[3]["state"]["ray"], 2);
    EXPECT_THAT(lines[3]["details"].get<std::string>(), HasSubstr("ray 2"));
    EXPECT_EQ(lines[4]["state"]["ray"], 0) << lines[4]["place"];
    EXPECT_THAT(lines[4]["row"][0].get<std::string>(), testing::StartsWith("0 "));
    EXPECT_TRUE(lines[5]["sweep"].is_number());
    EXPECT_THAT(lines[5]["lanes"].dump(), HasSubstr("inside"));
    EXPECT_TRUE(is_near(lines[6]["pixel"], 310, 220)) << lines[6]["pixel"];
    EXPECT_EQ(window.outcome.code, 0);
}

TEST_F(Window, says_why_a_walk_did_not_stop_and_what_was_not_followed) {
    const Reports window =
        run_window(screen, "glass_bowl",
                   "wait\nkey C\nstop nonsense\nstop depth >= 99\nkey Home\nkey C\ntype delete 1\n"
                   "weight 60\n");
    ASSERT_EQ(window.lines.size(), 8U) << window.outcome.err;
    const auto message = [&](std::size_t i) { return window.lines[i]["message"].get<std::string>(); };
    EXPECT_EQ(window.lines[0]["not_followed"], 6) << "as the terminal's tree tells";
    EXPECT_THAT(window.lines[0]["colours"].get<std::string>(),
                AllOf(HasSubstr("What was dropped"), HasSubstr("1 ray deeper than max_depth")));
    EXPECT_THAT(message(1), HasSubstr("no stop yet"));
    EXPECT_FALSE(window.lines[2]["ok"]);
    EXPECT_THAT(message(2), HasSubstr("no field or event is called 'nonsense'"));
    EXPECT_EQ(window.lines[3]["stops"], "1 stop");
    EXPECT_THAT(message(5), HasSubstr("No stop was met"));
    EXPECT_EQ(window.lines[6]["stops"], "no stops");
    EXPECT_LT(window.lines[7]["not_followed"], 6) << "light ones are hidden like light rays";
}

TEST_F(Window, sliders_change_the_scene_and_save_keeps_the_file_as_its_author_wrote_it) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "prism.toml";
    std::filesystem::copy_file(scenes + "04_refraction/prism.toml", file);
    const std::string before = content_of(file);
    const Reports window =
        run_window(screen, file.string(),
                   "wait\nmaterial glass\nslide index 1.2\nwait\nkey Ctrl+Z\nkey Ctrl+Shift+Z\n"
                   "slide reflection 0.05\nkey Ctrl+Z\nkey Ctrl+S\n");
    ASSERT_EQ(window.lines.size(), 9U) << window.outcome.err;
    const auto& lines = window.lines;
    EXPECT_FALSE(lines[1]["changed"]);
    EXPECT_TRUE(lines[2]["changed"]);
    EXPECT_NE(lines[2]["rays"], 0);
    EXPECT_THAT(lines[2]["materials"].dump(), HasSubstr("index 1.2"));
    EXPECT_FALSE(lines[4]["changed"]);
    EXPECT_THAT(lines[4]["materials"].dump(), HasSubstr("index 1.5"));
    EXPECT_TRUE(lines[5]["changed"]);
    EXPECT_FALSE(lines[8]["changed"]) << lines[8]["message"];
    std::string expected = before;
    expected.replace(expected.find("index = 1.5"), 11, "index = 1.2");
    EXPECT_EQ(content_of(file), expected);
    EXPECT_THAT(folder.names(), testing::ElementsAre("prism.toml"));
}

TEST_F(Window, values_that_the_file_lacks_go_beside_the_others_of_their_table_however_it_is_written) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "scene.toml";
    const std::string camera = "[camera]\neye = [0, -9, 2]\nlook_at = [0, 0, 0]\nfield_of_view = 40\n";
    std::ofstream(file) << camera << "[materials]\nwax.diffuse = 0.7 # dull\nice = { diffuse = 0.1 }\n"
                        << "[lights.lamp]\nposition = [-5, -9, 9]\n"
                        << "[generics]\n  ball.shape = \"sphere\"\n  ball.material = \"wax\"\n";
    const Reports window = run_window(screen, file.string(),
                                      "wait\nmaterial wax\nslide reflection 0.25\nmaterial ice\n"
                                      "slide reflection 0.5\nsolid ball 0 0\nsolid ball 20 0\nkey Ctrl+S\n");
    ASSERT_EQ(window.lines.size(), 8U) << window.outcome.err;
    EXPECT_FALSE(window.lines[7]["changed"]) << window.lines[7]["message"];
    const std::string saved = content_of(file);
    EXPECT_THAT(saved, HasSubstr("wax.diffuse = 0.7 # dull\nwax.reflection = 0.25\n"));
    EXPECT_THAT(saved, HasSubstr("ice = { diffuse = 0.1, reflection = 0.5 }\n"));
    EXPECT_THAT(saved, HasSubstr("  ball.material = \"wax\"\n  ball.transform = [{translate = ["));
}

TEST_F(Window, a_light_is_dragged_and_written_back) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "scene.toml";
    std::string text = content_of(scenes + "02_csg/two_spheres.toml");
    // The lamp among the things, where it can be seen and caught.
    const std::size_t from = text.find("position = ["), to = text.find(']', from);
    text.replace(from, to - from, "position = [0, 1.6, 1.2");
    std::ofstream(file) << text;
    const Reports window = run_window(screen, file.string(), "wait\nlight 0 25 10\nwait\nkey Ctrl+S\n");
    ASSERT_EQ(window.lines.size(), 4U) << window.outcome.err;
    EXPECT_TRUE(window.lines[1]["ok"]) << "the light is out of sight";
    EXPECT_TRUE(window.lines[1]["changed"]);
    EXPECT_FALSE(window.lines[3]["changed"]) << window.lines[3]["message"];
    EXPECT_NE(content_of(file), text);
}

TEST_F(Window, a_bad_file_is_told_and_the_scene_stays) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "bad.toml";
    std::ofstream(file) << "[camera]\neye = 3\n";
    const Reports window = run_window(screen, "two_spheres",
                                      "open " + file.string() + "\nopen no_such_scene\nopen prism\nwait\n");
    ASSERT_EQ(window.lines.size(), 4U) << window.outcome.err;
    EXPECT_THAT(window.lines[0]["message"].get<std::string>(), HasSubstr("bad.toml:2"));
    EXPECT_THAT(window.lines[0]["scene"].get<std::string>(), HasSubstr("two_spheres"));
    EXPECT_THAT(window.lines[1]["message"].get<std::string>(), HasSubstr("no_such_scene"));
    EXPECT_THAT(window.lines[2]["scene"].get<std::string>(), HasSubstr("prism"));
}

TEST_F(Window, the_console_is_the_terminal) {
    const Reports window = run_window(
        screen, "prism", "type break tir\ntype continue\ntype refraction\ntype nonsense\nresize 1000 700\n");
    ASSERT_EQ(window.lines.size(), 5U) << window.outcome.err;
    EXPECT_EQ(window.lines[1]["state"]["what"], "totally_reflected");
    EXPECT_EQ(window.lines[1]["card"]["θ₂"], "none: total internal reflection");
    EXPECT_THAT(window.lines[2]["console"].get<std::string>(), HasSubstr("critical"));
    EXPECT_THAT(window.lines[3]["console"].get<std::string>(), HasSubstr("unknown command"));
}

TEST_F(Window, real_keys_and_clicks_arrive) {
    if (std::system("command -v xdotool >/dev/null") != 0) GTEST_SKIP() << "there is no xdotool";
    // Keys move the walk; typed into the line of the console they are letters.
    const std::string display = "DISPLAY=:" + std::to_string(screen.number()) + " xdotool ";
    std::jthread hand([&] {
        const std::string keys = display +
                                 "search --sync --onlyvisible --name ' rayscope' windowfocus --sync " +
                                 "key --delay 60 n n s shift+n Home i s s colon 2>/dev/null";
        const std::string words = display + "type --delay 30 'goto 3' 2>/dev/null; " + display + "key Return";
        (void)!std::system((keys + "; sleep 2; " + words).c_str());
    });
    const Reports window = run_window(screen, "prism", "until 1 2\nuntil 3 0\n");
    ASSERT_EQ(window.lines.size(), 2U) << window.outcome.err;
    EXPECT_TRUE(window.lines[0]["ok"]) << window.lines[0]["state"];
    EXPECT_TRUE(window.lines[1]["ok"]) << window.lines[1]["state"];
    EXPECT_THAT(window.lines[1]["console"].get<std::string>(), HasSubstr("goto 3"));
}

TEST(WithoutDisplay, one_line_says_what_to_use_instead) {
    const Outcome outcome = run_program({"view", "prism"}, {RAYSCOPE_SOURCE_DIR, {"DISPLAY=:4711"}, {}});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("no display"), HasSubstr("rayscope step"), HasSubstr("--png")));
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1);
}

TEST(WithoutDisplay, a_bad_scene_is_told_as_by_other_commands) {
    const Outcome view = run_program({"view", "prismm"}), step = run_program({"step", "prismm"});
    EXPECT_EQ(view.code, 2);
    EXPECT_EQ(view.err, step.err);
}

} // namespace
} // namespace rayscope::test
