// While a question is open no panel tells the answer.

#include "tests/window/screen.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::vector<const char*> panels{"row",  "rays",    "place",  "details",   "lanes",
                                      "card", "colours", "octree", "pixel_text"};

void expect_hidden(const json& report) {
    SCOPED_TRACE(report["command"]);
    EXPECT_EQ(report["rays"], 1);
    EXPECT_EQ(report["row"][1], "?");
    EXPECT_EQ(report["row"][2], "?");
    EXPECT_EQ(report["space"]["rays"], 1);
    EXPECT_TRUE(report["card"].empty()) << report["card"];
    EXPECT_TRUE(report["octree"].is_null());
    EXPECT_THAT(report["details"].get<std::string>(), Not(HasSubstr("bowl")));
    EXPECT_THAT(report["place"].get<std::string>(), HasSubstr("of 0–?"));
    for (const char* text : {"details", "colours", "pixel_text"})
        EXPECT_THAT(report[text].get<std::string>(), HasSubstr("Hidden while a question is open")) << text;
    for (const char* text : {"colours", "pixel_text"})
        EXPECT_THAT(report[text].get<std::string>(), Not(HasSubstr("0.4"))) << text;
}

TEST_F(Window, a_question_hides_what_is_still_to_come_in_every_panel) {
    const Reports window =
        run_window(screen, "glass_bowl",
                   "tab Octree\nwait\nkey N\nkey Home\n"
                   "type quiz\nwait\nkey N\nkey Ctrl+Z\nslide index 1.1\nweight 0\nstage octree\ntab Octree\n"
                   "type 3\ntype quit\ntab Octree\nkey Home\nwait\n");
    ASSERT_EQ(window.lines.size(), 17U) << window.outcome.err;
    const auto& lines = window.lines;
    const json& before = lines[3];
    EXPECT_EQ(before["row"][1], "bowl");
    for (std::size_t i = 4; i <= 11; ++i) {
        expect_hidden(lines[i]);
        EXPECT_TRUE(lines[i]["lanes"].empty()) << lines[i]["command"];
        EXPECT_EQ(lines[i]["state"], before["state"]) << lines[i]["command"];
        EXPECT_FALSE(lines[i]["changed"]) << lines[i]["command"];
    }
    EXPECT_THAT(lines[6]["message"].get<std::string>(), HasSubstr("Answer in the console"));
    // "3" is no choice of a question with two: it is asked again.
    expect_hidden(lines[12]);
    for (const char* panel : panels) EXPECT_EQ(lines.back()[panel], before[panel]) << panel;
}

TEST_F(Window, an_answer_shows_what_led_to_it_and_no_more) {
    const Reports window =
        run_window(screen, "glass_bowl", "wait\ntype quiz\ntype 1\nwait\ntype quit\nwait\n");
    ASSERT_EQ(window.lines.size(), 6U) << window.outcome.err;
    const json& answered = window.lines[3];
    // It was asked whether a t is inside the bowl: now its intervals are seen, but not yet where the ray ends.
    EXPECT_THAT(answered["lanes"].dump(), AllOf(HasSubstr("bowl"), Not(HasSubstr("table"))));
    expect_hidden([&] {
        json rest = answered;
        rest["details"] = "Hidden while a question is open"; // the last event names the operands of the bowl
        return rest;
    }());
    EXPECT_EQ(window.lines[5]["rays"], window.lines[0]["rays"]);
    EXPECT_EQ(window.lines[5]["colours"], window.lines[0]["colours"]);
    EXPECT_THAT(window.lines[5]["lanes"].dump(), HasSubstr("table"));
}

} // namespace
} // namespace rayscope::test
