// Why a ray did not end on an object, asked in the conversation and by --why.

#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"
#include "visualizer/cli/session.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;
using testing::Not;

// A ball under a lamp, between floor and ceiling, and one that is aside of all.
const char* const room = R"(
[lights.lamp]
position = [0, 3, 0]
[materials.grey]
diffuse = 0.5
[generics.ball]
shape = "sphere"
material = "grey"
[generics.aside]
shape = "sphere"
material = "grey"
transform = [{translate = [5, 0, 0]}]
[generics.floor]
shape = "plane"
material = "grey"
transform = [{rotate_x = -90}, {translate = [0, -1.5, 0]}]
[generics.ceiling]
shape = "plane"
material = "grey"
transform = [{rotate_x = 90}, {translate = [0, 5, 0]}]
)";

class Why : public testing::Test {
protected:
    Why() { std::ofstream(folder.path() / "room.toml") << room; }

    const TemporaryFolder folder;
    const cli::StepStyle style{cli::Numbers(6), cli::Paint(false)};
};

TEST_F(Why, is_one_sentence_with_its_numbers) {
    const Workbench bench = open(folder.path() / "room.toml");
    const Trace trace = trace_ray(bench, {{0, 2, 0}, {0, -1, 0}});
    cli::Session session(bench, trace, style);
    EXPECT_EQ(session.answer("why ball"), "ball: the ray does end on it, at t = 1\n");
    EXPECT_EQ(session.answer("y aside"),
              "aside: the ray's line misses it: at its nearest, at t = 2, it is 4 outside (in\n"
              "the shape's own units)\n");
    EXPECT_EQ(session.answer("why  floor "),
              "floor: its nearest crossing, t = 3.5, lies behind the hit at t = 1\n");
    EXPECT_EQ(session.answer("why ceiling"),
              "ceiling: all its crossings lie behind the ray's origin, the last at t = -3\n");
    (void)session.answer("next"); // to the lamp
    EXPECT_EQ(session.answer("why ceiling"),
              "ceiling: its nearest crossing, t = 4, lies behind the light at t = 2\n");
    EXPECT_EQ(session.answer(""), "ceiling: its nearest crossing, t = 4, lies behind the light at t = 2\n");
    EXPECT_EQ(session.answer("why ball"), "ball: the ray starts on it, and no crossing lies ahead\n");
    EXPECT_EQ(session.answer("why floor"),
              "floor: all its crossings lie behind the ray's origin, the last at t = -2.5\n");
}

TEST_F(Why, knows_shadows_and_endless_insides) {
    const Workbench bench = open(folder.path() / "room.toml");
    const Trace shadow = trace_ray(bench, {{0, -1.25, 0}, {0, -1, 0}}); // the ball hides the lamp
    cli::Session session(bench, shadow, style);
    (void)session.answer("next");
    EXPECT_EQ(session.answer("why ball"), "ball: it stands in the light's way, at t = 0.5\n");
    const Trace below = trace_ray(bench, {{0, -2, 0}, {0, -1, 0}});
    EXPECT_EQ(cli::Session(bench, below, style).answer("why floor"),
              "floor: the ray is inside it from its start, and never leaves it\n");
}

TEST_F(Why, unknown_names_get_near_ones) {
    const Workbench bench = open(folder.path() / "room.toml");
    const Trace trace = trace_ray(bench, {{0, 2, 0}, {0, -1, 0}});
    cli::Session session(bench, trace, style);
    EXPECT_THAT(session.answer("why bal"), HasSubstr("why: no object 'bal' is drawn; did you mean 'ball'?"));
    EXPECT_THAT(session.answer("why xyzzy"), HasSubstr("expected ball, aside, floor or ceiling"));
    EXPECT_THAT(session.answer("why"), HasSubstr("expected the name of a drawn object"));
    EXPECT_THAT(session.answer("help"), HasSubstr("why-not, why"));
    EXPECT_EQ(session.current(), 0);
}

TEST_F(Why, is_told_of_each_ray_and_nothing_else) {
    const Outcome outcome =
        run_program({"step", "room.toml", "--ray", "0,2,0,0,-1,0", "--why", "ceiling"}, {folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "ray 0, eye          ceiling: all its crossings lie behind the ray's origin, the\n"
                           "                    last at t = -3\n"
                           "ray 1, shadow       ceiling: its nearest crossing, t = 4, lies behind the light\n"
                           "                    at t = 2\n");
    EXPECT_EQ(folder.names(), std::vector<std::string>{"room.toml"});
    const Outcome wrong = run_program({"step", "room.toml", "--why", "ceilling"}, {folder.path()});
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.err, HasSubstr("no object 'ceilling' is drawn; did you mean 'ceiling'?"));
}

TEST(WhyNot, of_the_glass_bowl_names_the_table_behind_it) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/glass_bowl.toml");
    const Trace trace = trace_pixel(bench, 235, 250);
    const cli::StepStyle style{cli::Numbers(3), cli::Paint(false)};
    EXPECT_EQ(cli::Session(bench, trace, style).answer("why table"),
              "table: its nearest crossing, t = 7.49, lies behind the hit at t = 4.84\n");
}

TEST(RayText, says_where_the_record_was_full) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/glass_bowl.toml");
    Trace trace = trace_pixel(bench, 235, 250);
    const cli::StepStyle style{cli::Numbers(6), cli::Paint(false)};
    const std::string full = "Here the record was full";
    for (const int ray : {0, 1}) {
        EXPECT_THAT(ray_text(trace, ray, style), Not(HasSubstr(full)));
        auto& events = trace.rays[std::size_t(ray)].events;
        events.insert(events.end() - 1, Truncated{100});
        const std::string text = ray_text(trace, ray, style);
        EXPECT_LT(text.find(full), text.find(ray == 0 ? "Colour that it brings back" : "Is the light seen?"));
    }
}

TEST(RayText, tells_a_total_reflection_once) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml");
    const Trace trace = trace_pixel(bench, bench.scene.step_pixel->first, bench.scene.step_pixel->second);
    const cli::StepStyle style{cli::Numbers(6), cli::Paint(false)};
    int total = 0;
    for (std::size_t ray = 0; ray < trace.rays.size(); ++ray) {
        if (trace.rays[ray].find<TotallyReflected>() == nullptr) continue;
        ++total;
        const std::string text = ray_text(trace, int(ray), style);
        EXPECT_THAT(text, HasSubstr("Total internal reflection: no θ₂ exists"));
        EXPECT_THAT(text, Not(HasSubstr("no refracted direction")));
        const std::string refusals = text.substr(std::min(text.find("Not followed"), text.size()));
        EXPECT_THAT(refusals, Not(HasSubstr("\n  refracted ")));
    }
    EXPECT_GT(total, 0);
    EXPECT_THAT(tree_text(trace, style), HasSubstr("is totally reflected at "));
}

} // namespace
} // namespace rayscope::test
