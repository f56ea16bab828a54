#include "core/files/markup.hpp"
#include "exercises/grader/results.hpp"

#include <fmt/format.h>

namespace rayscope::exercises {
namespace {

std::string case_text(const ExerciseMark& exercise, const GroupMark& group, bool& failed) {
    const std::string head = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"",
                                         in_markup(exercise.id), in_markup(group.name));
    failed = group.right < group.cases;
    if (!failed) return head + "/>\n";
    const std::string message = !exercise.problem.empty() ? exercise.problem
                                : exercise.says.empty()
                                    ? fmt::format("{} of {} cases are right", group.right, group.cases)
                                    : exercise.says;
    return fmt::format("{}>\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n", head,
                       in_markup(message), in_markup(group.output));
}

} // namespace

std::string junit_text(const std::vector<SubmissionMark>& marks) {
    std::string suites;
    int all_tests = 0, all_failures = 0;
    for (const SubmissionMark& mark : marks) {
        std::string cases;
        int tests = 0, failures = 0;
        for (const ExerciseMark& exercise : mark.exercises)
            for (const GroupMark& group : exercise.groups) {
                bool failed = false;
                cases += case_text(exercise, group, failed);
                ++tests;
                failures += failed ? 1 : 0;
            }
        suites += fmt::format("  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"0\" "
                              "skipped=\"0\" time=\"0\">\n{}  </testsuite>\n",
                              in_markup(mark.student), tests, failures, cases);
        all_tests += tests;
        all_failures += failures;
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"rayscope exercises\" tests=\"{}\" "
        "failures=\"{}\" errors=\"0\" time=\"0\">\n{}</testsuites>\n",
        all_tests, all_failures, suites);
}

} // namespace rayscope::exercises
