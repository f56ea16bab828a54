// What is dragged in the 3D view changes the scene, or the ray.

#include "tests/window/screen.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

// Every way in which a file can say where a generic is.
const char* const scene_text = R"(# three balls
[camera]
eye = [0, 1, 6]
look_at = [0, 0, 0]
resolution = [80, 60]

[lights.lamp]
position = [3, 5, 4]

[materials.red]
diffuse = [0.8, 0.2, 0.1]
reflection = 0.2

[generics] # those in one line
inline = {shape = "sphere", material = "red"} # a ball

[generics.headed] # with a head of its own
shape = "sphere" # no transform
material = "red"

[generics.listed]
shape = "sphere"
material = "red"
transform = [
    {scale = 0.5},             # small
    {translate = [1.25, 0, 0]}, # aside
    {rotate_y = 20},           # and turned
]

[generics.moved]
shape = "cube"
material = "red"
transform = [{scale = 0.3}, {translate = [ -1.5, 0.25,  0.125 ]}] # as last step
)";

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

std::string numbers(const json& list) {
    std::string text;
    for (const json& number : list) text += (text.empty() ? "" : ",") + number.dump();
    return text;
}

void expect_near(const json& a, const json& b) {
    ASSERT_EQ(a.size(), b.size()) << a << b;
    for (std::size_t i = 0; i < a.size(); ++i)
        EXPECT_NEAR(a[i].get<double>(), b[i].get<double>(), 1e-12) << a << b;
}

/// Drags one solid and saves: the file's lines, and what a window says that reads it anew.
std::vector<std::string> dragged(const Screen& screen, const std::string& name) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "scene.toml";
    std::ofstream(file) << scene_text;
    const Reports window =
        run_window(screen, file.string(), "wait\nsolid " + name + " 24 -11\nwait\nkey Ctrl+S\n");
    EXPECT_TRUE(window.lines.at(1)["ok"]) << name << " is out of sight";
    EXPECT_TRUE(window.lines.at(1)["changed"]);
    EXPECT_FALSE(window.last()["changed"]) << window.last()["message"];
    const Reports again = run_window(screen, file.string(), "wait\nsolid " + name + " 0 0\n");
    expect_near(again.last()["handles"][name], window.last()["handles"][name]);
    EXPECT_EQ(again.last()["rays"], window.last()["rays"]);
    return lines_of(content_of(file));
}

TEST_F(Window, a_dragged_solid_is_written_where_its_file_has_its_place) {
    const std::vector<std::string> before = lines_of(scene_text);
    const auto line = [&](const char* begin) {
        return std::size_t(
            std::ranges::find_if(before, [&](const std::string& l) { return l.starts_with(begin); }) -
            before.begin());
    };
    const auto expect = [&](const char* name, std::size_t at, bool fresh, const auto& matches) {
        std::vector<std::string> after = dragged(screen, name);
        ASSERT_GT(after.size(), at) << name;
        EXPECT_THAT(after[at], matches) << name;
        std::vector<std::string> others = before;
        if (!fresh) others.erase(others.begin() + std::ptrdiff_t(at));
        after.erase(after.begin() + std::ptrdiff_t(at));
        EXPECT_EQ(after, others) << name;
    };
    using testing::MatchesRegex;
    expect("inline", line("inline"), false,
           MatchesRegex("inline = \\{shape = \"sphere\", material = \"red\", "
                        "transform = \\[\\{translate = \\[[-.0-9, ]+\\]\\}\\]\\} # a ball"));
    expect("headed", line("[generics.headed]") + 1, true,
           MatchesRegex("transform = \\[\\{translate = \\[[-.0-9, ]+\\]\\}\\]"));
    expect(
        "listed", line("    {rotate_y"), false,
        MatchesRegex("    \\{rotate_y = 20\\}, \\{translate = \\[[-.0-9, ]+\\]\\},           # and turned"));
    expect("moved", line("transform = [{scale = 0.3}"), false,
           MatchesRegex(
               "transform = \\[\\{scale = 0.3\\}, \\{translate = \\[ [-.0-9]+, [-.0-9]+,  [-.0-9]+ \\]\\}\\] "
               "# as last step"));
}

TEST_F(Window, an_operand_caught_on_its_surface_moves_and_rays_follow_until_it_is_undone) {
    const Reports window = run_window(screen, "glass_bowl",
                                      "wait\npull 0.35 0.47 30 -20\nwait\nkey Ctrl+Z\nkey Ctrl+Shift+Z\n"
                                      "orbit 60 10\nstate\n");
    ASSERT_EQ(window.lines.size(), 7U) << window.outcome.err;
    const auto& lines = window.lines;
    const json origin = {0.0, 0.0, 0.0};
    EXPECT_TRUE(lines[1]["ok"]);
    ASSERT_TRUE(lines[1]["handles"].contains("outer")) << lines[1]["handles"];
    EXPECT_NE(lines[1]["handles"]["outer"], origin);
    EXPECT_NE(lines[1]["handles"]["end"], lines[0]["handles"]["end"]);
    EXPECT_EQ(lines[3]["handles"]["outer"], origin);
    EXPECT_EQ(lines[3]["handles"]["end"], lines[0]["handles"]["end"]);
    EXPECT_FALSE(lines[3]["changed"]);
    EXPECT_EQ(lines[4]["handles"], lines[1]["handles"]);
    EXPECT_EQ(lines[6]["handles"], lines[1]["handles"]) << "turning the camera moves nothing";
}

TEST_F(Window, the_ends_of_the_ray_are_dragged_as_if_it_were_given) {
    const Reports window = run_window(screen, "two_spheres",
                                      "wait\nend 25 15\nkey Ctrl+Z\nkey Ctrl+Shift+Z\nstart 12 -30\nwait\n",
                                      {"--ray", "0.2,0.1,3,0,0,-1"});
    ASSERT_EQ(window.lines.size(), 6U) << window.outcome.err;
    const auto& lines = window.lines;
    for (const json& line : lines) EXPECT_TRUE(line["ok"]) << line["command"];
    EXPECT_EQ(lines[1]["handles"]["start"], lines[0]["handles"]["start"]);
    EXPECT_NE(lines[1]["handles"]["end"], lines[0]["handles"]["end"]);
    EXPECT_EQ(lines[2]["handles"], lines[0]["handles"]);
    EXPECT_EQ(lines[3]["handles"], lines[1]["handles"]);
    EXPECT_NE(lines[4]["handles"]["start"], lines[0]["handles"]["start"]);
    EXPECT_FALSE(lines[4]["changed"]) << "a ray is no part of the scene";
    const json &start = lines[5]["handles"]["start"], &end = lines[5]["handles"]["end"];
    json direction;
    for (std::size_t i = 0; i < 3; ++i) direction.push_back(end[i].get<double>() - start[i].get<double>());
    const Reports given =
        run_window(screen, "two_spheres", "wait\n", {"--ray", numbers(start) + "," + numbers(direction)});
    EXPECT_EQ(given.last()["rays"], lines[5]["rays"]);
    EXPECT_EQ(given.last()["row"][1], lines[5]["row"][1]);
    expect_near(given.last()["handles"]["end"], end);
}

TEST_F(Window, the_ray_of_a_pixel_becomes_one_by_hand_and_undo_brings_the_pixel_back) {
    const Reports window = run_window(screen, "glass_bowl", "wait\nend 20 10\nkey Ctrl+Z\n");
    ASSERT_EQ(window.lines.size(), 3U) << window.outcome.err;
    EXPECT_TRUE(window.lines[0]["pixel"].is_array());
    EXPECT_TRUE(window.lines[1]["pixel"].is_null());
    EXPECT_EQ(window.lines[2]["pixel"], window.lines[0]["pixel"]);
    EXPECT_EQ(window.lines[2]["state"], window.lines[0]["state"]);
}

} // namespace
} // namespace rayscope::test
