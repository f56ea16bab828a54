// The octree's picture shows what the terminal tells of the same ray.

#include "tests/window/screen.hpp"

#include <gmock/gmock.h>

#include <regex>

namespace rayscope::test {
namespace {

using nlohmann::json;

/// Balls in a grid, each a little off its place.
std::string grid(int side) {
    std::string text = "[camera]\neye = [0.3, 0.4, 3.5]\nlook_at = [0, 0, 0]\nresolution = [64, 48]\n"
                       "[lights.lamp]\nposition = [3, 5, 4]\n[materials.red]\ndiffuse = 0.7\n";
    for (int i = 0; i < side * side * side; ++i) {
        std::string place;
        for (int axis = 0, rest = i; axis < 3; ++axis, rest /= side)
            place += (axis > 0 ? ", " : "") + std::to_string((rest % side + 0.5) * 2.0 / side - 1 +
                                                             0.1 * ((i * 7 + axis * 3) % 5 - 2) / side);
        text +=
            "[generics.b" + std::to_string(i) +
            "]\nshape = \"sphere\"\nmaterial = \"red\"\ntransform = [{scale = " + std::to_string(0.7 / side) +
            "}, {translate = [" + place + "]}]\n";
    }
    return text;
}

TEST_F(Window, the_octree_is_drawn_with_the_counts_of_the_terminal_down_to_a_level) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "grid.toml", script = folder.path() / "script";
    std::ofstream(file) << grid(6);
    std::ofstream(script) << "cells octree\n";
    const Outcome terminal =
        run_program({"step", file.string(), "--pixel", "30,22", "--script", script.string()});
    std::smatch counts;
    const std::regex summary(R"(octree: (\d+) cells?, (\d+) tests?, (\d+) saved of (\d+) objects)");
    ASSERT_TRUE(std::regex_search(terminal.out, counts, summary)) << terminal.out << terminal.err;

    const Reports window =
        run_window(screen, file.string(), "wait\ntab Octree\nlevel 1\nlevel 0\nlevel 9\npick 2 2\n",
                   {"--pixel", "30,22"});
    ASSERT_EQ(window.lines.size(), 6U) << window.outcome.err;
    EXPECT_TRUE(window.lines[0]["octree"].is_null()) << "nobody looks at it yet";
    const json& all = window.lines[1]["octree"];
    EXPECT_EQ(all["tested"].get<int>() + all["spared"].get<int>(), std::stoi(counts[1]));
    EXPECT_EQ(all["objects_tested"], std::stoi(counts[2]));
    EXPECT_EQ(all["objects"], std::stoi(counts[4]));
    EXPECT_GE(all["levels"].get<int>(), 2);
    EXPECT_GT(all["empty"].get<int>() + all["divided"].get<int>(), 2);
    int undivided = 0;
    for (const json& column : all["held"]) undivided += column[1].get<int>();
    EXPECT_EQ(undivided, std::stoi(counts[1]));
    EXPECT_EQ(window.lines[2]["octree"]["level"], 1);
    EXPECT_LT(window.lines[2]["octree"]["tested"], all["tested"]);
    EXPECT_EQ(window.lines[3]["octree"]["divided"], 1) << "the root alone";
    EXPECT_EQ(window.lines[4]["octree"], all);
    EXPECT_NE(window.lines[5]["octree"], all) << "of another ray";
}

} // namespace
} // namespace rayscope::test
