// A new exercise out of an event of a recorded trace: for each kind that an exercise's function answers, and no other.

#include "core/scene/input_error.hpp"
#include "exercises/grader/cut_case.hpp"
#include "exercises/grader/verify.hpp"
#include "exercises/program/commands.hpp"
#include "tests/exercises/grading.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <map>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;
using namespace exercises;
using exercises::Reference; // not rayscope's own
using testing::HasSubstr;
using testing::IsEmpty;

Trace recorded(const std::string& scene, const char* stage) {
    const Workbench bench = open(std::string(RAYSCOPE_SOURCE_DIR "/chapters/") + scene);
    const auto stages = make_stages(bench, stage_choice(stage));
    return trace_pixel(bench, *stages, bench.scene.camera.width / 2, bench.scene.camera.height / 2);
}

/// Rays that do everything that an exercise asks for.
const std::vector<Trace>& traces() {
    static const std::vector<Trace> all{
        recorded("02_csg/glass_bowl.toml", "extents"), recorded("03_reflection/facing_mirrors.toml", "scan"),
        recorded("08_effects/diamond.toml", "octree"), recorded("01_generics/torus_chain.toml", "octree"),
        recorded("07_accuracy/nested_glass.toml", "octree")};
    return all;
}

struct Found {
    std::size_t trace = 0;
    int event = 0;
};
/// The first event of each exercise that is asked for, and of all kinds whose names are told in an error.
struct Events {
    std::map<std::string, Found> exercises;
    std::map<std::string, Found> refused;
};
const Events& events() {
    static const Events all = [] {
        Events made;
        for (std::size_t i = 0; i < traces().size(); ++i) {
            std::size_t count = 0;
            for (const TracedRay& ray : traces()[i].rays) count += ray.events.size();
            for (int event = 0; event < int(count); ++event) {
                try {
                    made.exercises.try_emplace(cut_case(traces()[i], event).exercise, Found{i, event});
                } catch (const InputError& error) {
                    const std::string& text = error.message;
                    const std::size_t begin = text.find('\'') + 1;
                    made.refused.try_emplace(text.substr(begin, text.find('\'', begin) - begin),
                                             Found{i, event});
                }
            }
        }
        return made;
    }();
    return all;
}

const std::vector<std::string> reached{"2-01-inside-list", "2-03-tree",      "3-01-mirror", "3-02-chain",
                                       "3-03-stop",        "4-02-refract",   "4-03-wall",   "5-01-slab",
                                       "6-02-order",       "6-03-first-hit", "7-03-spawn",  "8-02-fresnel"};

TEST(CutEvents, belong_to_these_exercises) {
    std::vector<std::string> found;
    for (const auto& [exercise, place] : events().exercises) found.push_back(exercise);
    EXPECT_EQ(found, reached);
}

TEST(CutEvents, of_other_kinds_are_refused_by_name) {
    for (const char* kind : {"ambient_lit", "light_lit", "search_began", "place_left"})
        EXPECT_TRUE(events().refused.contains(kind)) << kind;
    for (const char* kind : {"reflected", "refracted", "totally_reflected", "node_evaluated", "span_found"})
        EXPECT_FALSE(events().refused.contains(kind)) << kind;
}

TEST(CutEvents, must_be_there) {
    for (const int event : {-1, 1 << 30}) try {
            (void)cut_case(traces()[0], event);
            FAIL() << event;
        } catch (const InputError& error) {
            EXPECT_THAT(error.message, HasSubstr("expected 0 to"));
        }
}

class NewFromTrace : public InSandbox, public testing::WithParamInterface<std::string> {
protected:
    /// Made as the command makes it.
    [[nodiscard]] Exercise made() const {
        const Found& found = events().exercises.at(GetParam());
        write_trace(traces()[found.trace], folder_.path() / "ray.json");
        New command;
        command.folder = folder_.path() / "9-01-new";
        command.trace = folder_.path() / "ray.json";
        command.event = found.event;
        testing::internal::CaptureStdout();
        EXPECT_EQ(run(Context{{}, catalogue()}, command), 0);
        (void)testing::internal::GetCapturedStdout();
        return read_exercise(command.folder);
    }

private:
    TemporaryFolder folder_;
};

TEST_P(NewFromTrace, has_the_event_as_a_case_that_our_solution_answers) {
    const Exercise exercise = made();
    const Reference reference = make_reference(toolchain(), exercise, 1);
    EXPECT_THAT(reference.cases.front().about, HasSubstr("of a recorded trace"));
    CaseRunner judge(toolchain(), reference.program);
    if (!exercise.judged) return;
    EXPECT_EQ(judged(judge, reference.cases.front(), reference.outcomes[0].front().value), "");
}
INSTANTIATE_TEST_SUITE_P(Quick, NewFromTrace, testing::ValuesIn(reached),
                         [](const auto& one) { return test_name(one.param); });

class NewFromTraceFull : public NewFromTrace {};
TEST_P(NewFromTraceFull, passes_verification) {
    EXPECT_THAT(problems_of(toolchain(), made(), {1, 2}), IsEmpty());
}
INSTANTIATE_TEST_SUITE_P(Slow, NewFromTraceFull, testing::ValuesIn(reached),
                         [](const auto& one) { return test_name(one.param); });

} // namespace
} // namespace rayscope::test
