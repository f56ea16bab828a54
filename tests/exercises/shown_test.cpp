// The recorded ray of a wrong case: each exercise has one for each case, and where an answer can be drawn, both rays part.

#include "exercises/grader/shown_case.hpp"
#include "exercises/grader/units.hpp"
#include "tests/exercises/grading.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using namespace exercises;
using exercises::Reference; // not rayscope's own

/// What a student's file would become.
std::filesystem::path program_of(const Exercise& exercise, const std::filesystem::path& file) {
    return toolchain().kept(answer_unit(exercise, read_code(file))).program;
}

/// The runs of a case by the solution, or by no function of the tracer's at all.
std::optional<ShownRuns> shown_right(const Reference& reference, std::size_t index,
                                     const std::filesystem::path& program = {}) {
    return shown_runs(toolchain(), reference, index, reference.outcomes[0][index], program);
}

class ShownRay : public InSandbox, public testing::WithParamInterface<std::string> {};

TEST_P(ShownRay, is_there_for_each_case) {
    const Exercise& exercise = find_exercise(catalogue(), GetParam());
    const Reference reference = make_reference(toolchain(), exercise, 1);
    const auto solution = program_of(exercise, exercise.solution());
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        const auto runs = shown_right(reference, i, solution);
        ASSERT_TRUE(runs) << reference.cases[i].about;
        EXPECT_TRUE(runs->shown.yours.empty()) << "the right answer is no other scene";
        EXPECT_EQ(runs->yours.has_value(), !exercise.formula.empty()) << reference.cases[i].about;
        EXPECT_FALSE(runs->parted) << reference.cases[i].about;
    }
}
INSTANTIATE_TEST_SUITE_P(Quick, ShownRay, testing::ValuesIn(ids()),
                         [](const auto& one) { return test_name(one.param); });

/// The first wrong case that students see, of the solution that is known to be wrong.
std::optional<ShownRuns> told(const std::string& exercise, const std::string& misconception) {
    const Reference reference = make_reference(toolchain(), find_exercise(catalogue(), exercise), 1);
    const auto& list = reference.exercise->misconceptions;
    const auto variant =
        std::size_t(std::ranges::find(list, misconception, &Misconception::name) - list.begin()) + 1;
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        const Outcome& answer = reference.outcomes[variant][i];
        const bool hidden = reference.exercise->groups[reference.cases[i].group].hidden;
        if (!hidden && !same(answer, reference.outcomes[0][i], reference.exercise->tolerance))
            return shown_runs(toolchain(), reference, i, answer,
                              program_of(*reference.exercise, list[variant - 1].file));
    }
    return std::nullopt;
}

/// "2-04-flat": an exercise and one of its misconceptions.
class WrongAnswer : public InSandbox, public testing::WithParamInterface<std::string> {};

TEST_P(WrongAnswer, has_a_ray_that_parts_from_the_right_one) {
    const auto runs = told(GetParam().substr(0, 4), GetParam().substr(5));
    ASSERT_TRUE(runs);
    ASSERT_TRUE(runs->yours);
    EXPECT_TRUE(runs->parted);
}
INSTANTIATE_TEST_SUITE_P(Quick, WrongAnswer,
                         testing::Values("2-04-flat", "2-04-right", "2-03-reversed", "3-02-off-by-1",
                                         "3-02-cut-bg", "3-03-single", "3-03-no-eps", "4-01-notes",
                                         "4-01-reversed", "4-04-dry", "5-02-notes", "5-02-two", "6-01-bits",
                                         "6-02-index", "6-02-behind", "6-03-eager", "7-02-length",
                                         "7-03-outside", "8-01-both", "1-04-infinite", "1-01-w1", "1-01-unit",
                                         "4-03-lit", "4-03-no-flip", "4-03-no-swap", "4-03-no-tir",
                                         "8-02-flat", "8-02-inverse", "8-02-schlick"),
                         [](const auto& one) { return test_name(one.param); });

// Each says of the case what the tracer says of the ray.

TEST_F(InSandbox, a_path_of_mirrors_has_the_colour_that_is_asked_for) {
    const Reference reference = make_reference(toolchain(), find_exercise(catalogue(), "3-02"), 1);
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        const auto runs = shown_right(reference, i);
        const auto& fields = std::get<Record>(reference.outcomes[0][i].value.content).fields;
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(runs->right.colour[axis], std::get<double>(fields[std::size_t(axis)].value.content),
                        1e-9)
                << reference.cases[i].about;
    }
}

TEST_F(InSandbox, facing_mirrors_send_as_many_rays_as_are_asked_for) {
    const Reference reference = make_reference(toolchain(), find_exercise(catalogue(), "3-03"), 1);
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        const auto right = std::get<std::int64_t>(reference.outcomes[0][i].value.content);
        if (right > 256) continue; // more than a scene may ask for
        const auto runs = shown_right(reference, i);
        EXPECT_EQ(std::int64_t(runs->right.rays.size()) - 1, right) << reference.cases[i].about;
    }
}

TEST_F(InSandbox, layers_have_the_speeds_that_are_asked_for) {
    const Reference reference = make_reference(toolchain(), find_exercise(catalogue(), "4-04"), 1);
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        const auto runs = shown_right(reference, i);
        const auto& right = std::get<List>(reference.outcomes[0][i].value.content);
        std::size_t crossing = 0;
        for (const TracedRay& ray : runs->right.rays) {
            const auto* hit = ray.find<BoundaryChosen>();
            if (ray.start().kind == RayKind::shadow || hit == nullptr) continue;
            ASSERT_LT(crossing, right.size()) << reference.cases[i].about;
            const auto& pair = std::get<Record>(right[crossing++].content).fields;
            EXPECT_NEAR(hit->speed_from, std::get<double>(pair[0].value.content), 1e-12);
            EXPECT_NEAR(hit->speed_to, std::get<double>(pair[1].value.content), 1e-12);
        }
        EXPECT_EQ(crossing, right.size()) << reference.cases[i].about;
    }
}

TEST_F(InSandbox, no_text_of_an_answer_gets_into_a_scene) {
    const Reference reference = make_reference(toolchain(), find_exercise(catalogue(), "2-04"), 1);
    Outcome evil;
    evil.kind = OutcomeKind::answered;
    evil.value = {std::string("A\"\n[generics.x]\nshape = \"mesh\"\nfile = \"/etc/passwd\"\n#")};
    const auto runs = shown_runs(toolchain(), reference, 0, evil, {});
    ASSERT_TRUE(runs);
    EXPECT_TRUE(runs->shown.yours.empty());
}

} // namespace
} // namespace rayscope::test
