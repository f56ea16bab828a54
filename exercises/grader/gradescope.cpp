#include "exercises/grader/results.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rayscope::exercises {
namespace {

std::string group_output(const ExerciseMark& exercise, const GroupMark& group) {
    if (!exercise.compiled)
        return exercise.handed_in ? "It does not compile:\n" + exercise.problem : exercise.problem;
    std::string text = group.output;
    if (!exercise.says.empty() && group.right < group.cases) text += "\n" + exercise.says + "\n";
    return text;
}

/// So that nobody takes the points that are shown for all points.
std::string overview(const SubmissionMark& mark) {
    int hidden = 0;
    for (const ExerciseMark& exercise : mark.exercises)
        for (const GroupMark& group : exercise.groups) hidden += group.hidden ? group.points : 0;
    std::string text = fmt::format("{} points in all.", mark.points);
    if (hidden > 0)
        text += fmt::format(
            " {} of them are for hidden cases: you see what they brought once grades are published.", hidden);
    return text;
}

} // namespace

std::string gradescope_text(const SubmissionMark& mark) {
    nlohmann::ordered_json tests = nlohmann::ordered_json::array();
    double limits_used = 0;
    int exercise_number = 0;
    for (const ExerciseMark& exercise : mark.exercises) {
        ++exercise_number;
        limits_used += exercise.limits_used;
        int group_number = 0;
        for (const GroupMark& group : exercise.groups)
            tests.push_back(
                {{"score", group.score},
                 {"max_score", group.points},
                 {"status", group.right == group.cases ? "passed" : "failed"},
                 {"name", fmt::format("{} {}{}", exercise.id, group.name, group.hidden ? " (hidden)" : "")},
                 {"number", fmt::format("{}.{}", exercise_number, ++group_number)},
                 {"output", group_output(exercise, group)},
                 {"output_format", "text"},
                 {"visibility", group.hidden ? "after_published" : "visible"},
                 {"extra_data",
                  {{"exercise", exercise.id},
                   {"cases", group.cases},
                   {"right", group.right},
                   {"misconception", exercise.misconception}}}});
    }
    const nlohmann::ordered_json document{{"score", mark.score},      {"execution_time", limits_used},
                                          {"output", overview(mark)}, {"output_format", "text"},
                                          {"visibility", "visible"},  {"stdout_visibility", "hidden"},
                                          {"tests", std::move(tests)}};
    return document.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace rayscope::exercises
