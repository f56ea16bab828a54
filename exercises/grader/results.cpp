#include "exercises/grader/results.hpp"

#include "exercises/runner/time_limits.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rayscope::exercises {
namespace {

// What a program had that does not end: the first time, and from then on.
constexpr double first_limit = std::chrono::duration<double>(runner::most_computing).count(),
                 later_limit = std::chrono::duration<double>(runner::later_computing).count();

double hundredths(double points) { return std::round(100 * points) / 100; }

std::string case_text(const Reference& reference, const Grade& grade, std::size_t index) {
    const Case& asked = reference.cases[index];
    const CaseResult& result = grade.cases[index];
    std::string arguments;
    for (const Value& value : asked.arguments) arguments += (arguments.empty() ? "" : ", ") + text_of(value);
    std::string text = fmt::format("{}\n  asked     {}({})\n  expected  {}\n  got       {}\n", asked.about,
                                   reference.exercise->functions[asked.function].name, arguments,
                                   text_of(reference.outcomes[0][index]), text_of(result.outcome));
    if (!result.complaint.empty()) text += fmt::format("  but       {}\n", result.complaint);
    return text;
}

GroupMark group_mark(const Reference& reference, const Grade& grade, std::size_t group) {
    const Group& asked = reference.exercise->groups[group];
    const GroupResult& result = grade.groups[group];
    GroupMark mark{asked.name, asked.hidden, result.score, asked.points, result.right, result.cases, {}};
    mark.output = fmt::format("{} of {} cases are right.\n", result.right, result.cases);
    for (std::size_t i = 0; i < grade.cases.size() && !asked.hidden; ++i)
        if (reference.cases[i].group == group && !grade.cases[i].right) {
            mark.output += "\n" + case_text(reference, grade, i);
            break;
        }
    return mark;
}

std::string problem_text(const Grade& grade, const std::string& file) {
    std::string text = grade.problem;
    for (const Diagnostic& diagnostic : grade.diagnostics)
        if (diagnostic.error)
            text += fmt::format("{}{}:{}: {}", text.empty() ? "" : "\n", file, diagnostic.line,
                                diagnostic.message);
    return text;
}

} // namespace

ExerciseMark mark_of(const Reference& reference, const Grade& grade, bool handed_in) {
    const Exercise& exercise = *reference.exercise;
    ExerciseMark mark;
    mark.id = exercise.id;
    mark.title = exercise.title;
    mark.handed_in = handed_in;
    mark.compiled = grade.compiled;
    mark.points = exercise.points;
    mark.score = grade.score;
    for (std::size_t i = 0; i < exercise.groups.size(); ++i)
        mark.groups.push_back(group_mark(reference, grade, i));
    if (grade.misconception) {
        mark.misconception = exercise.misconceptions[*grade.misconception].name;
        mark.says = exercise.misconceptions[*grade.misconception].says;
    }
    if (!grade.compiled)
        mark.problem = handed_in ? problem_text(grade, exercise.file_name()) : "not handed in";
    const auto late = std::ranges::count(grade.cases, OutcomeKind::timed_out,
                                         [](const CaseResult& result) { return result.outcome.kind; });
    mark.limits_used = late == 0 ? 0 : hundredths(first_limit + later_limit * double(late - 1));
    return mark;
}

SubmissionMark mark_of(std::string student, std::vector<ExerciseMark> exercises) {
    SubmissionMark mark;
    mark.student = std::move(student);
    mark.exercises = std::move(exercises);
    for (const ExerciseMark& exercise : mark.exercises) {
        mark.score += exercise.score;
        mark.points += exercise.points;
    }
    mark.score = hundredths(mark.score);
    return mark;
}

nlohmann::json to_json(const SubmissionMark& mark) {
    nlohmann::json exercises = nlohmann::json::array();
    for (const ExerciseMark& exercise : mark.exercises) {
        nlohmann::json groups = nlohmann::json::array();
        for (const GroupMark& group : exercise.groups)
            groups.push_back({{"name", group.name},
                              {"hidden", group.hidden},
                              {"score", group.score},
                              {"points", group.points},
                              {"right", group.right},
                              {"cases", group.cases},
                              {"output", group.output}});
        nlohmann::json entry{{"id", exercise.id},
                             {"title", exercise.title},
                             {"handed_in", exercise.handed_in},
                             {"compiled", exercise.compiled},
                             {"score", exercise.score},
                             {"points", exercise.points},
                             {"groups", std::move(groups)},
                             {"misconception", exercise.misconception},
                             {"says", exercise.says},
                             {"problem", exercise.problem},
                             {"limits_used", exercise.limits_used}};
        if (const auto& ray = exercise.ray)
            entry["ray"] = {{"scene", ray->scene},
                            {"yours", ray->yours},
                            {"ray", ray->ray},
                            {"note", ray->note},
                            {"drawing", ray->drawing}};
        exercises.push_back(std::move(entry));
    }
    return {{"student", mark.student},
            {"score", mark.score},
            {"points", mark.points},
            {"exercises", std::move(exercises)}};
}

SubmissionMark mark_from_json(const nlohmann::json& document) {
    SubmissionMark mark;
    mark.student = document.at("student");
    mark.score = document.at("score");
    mark.points = document.at("points");
    for (const auto& entry : document.at("exercises")) {
        ExerciseMark exercise;
        exercise.id = entry.at("id");
        exercise.title = entry.at("title");
        exercise.handed_in = entry.at("handed_in");
        exercise.compiled = entry.at("compiled");
        exercise.score = entry.at("score");
        exercise.points = entry.at("points");
        exercise.misconception = entry.at("misconception");
        exercise.says = entry.at("says");
        exercise.problem = entry.at("problem");
        exercise.limits_used = entry.at("limits_used");
        if (entry.contains("ray")) {
            const auto& ray = entry["ray"];
            exercise.ray =
                ShownRay{ray.at("scene"), ray.at("yours"), ray.at("ray"), ray.at("note"), ray.at("drawing")};
        }
        for (const auto& group : entry.at("groups"))
            exercise.groups.push_back({group.at("name"), group.at("hidden"), group.at("score"),
                                       group.at("points"), group.at("right"), group.at("cases"),
                                       group.at("output")});
        mark.exercises.push_back(std::move(exercise));
    }
    return mark;
}

} // namespace rayscope::exercises
