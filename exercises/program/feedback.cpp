#include "exercises/program/feedback.hpp"

#include <fmt/format.h>

#include <sstream>

namespace rayscope::exercises {
namespace {

constexpr std::size_t most_diagnostics = 3;

std::string line_of(const std::string& code, int number) {
    std::istringstream lines(code);
    std::string line;
    for (int i = 0; i < number && std::getline(lines, line); ++i) {
    }
    return line.substr(0, 200);
}

std::string diagnostics_text(const Grade& grade, bool errors, const Feedback& feedback,
                             const std::string& file, const Screen& screen) {
    std::string text;
    std::size_t count = 0;
    for (const Diagnostic& diagnostic : grade.diagnostics) {
        if (diagnostic.error != errors || count++ == most_diagnostics) continue;
        text += fmt::format("\n  {}:{}: {}\n    {}\n", file, diagnostic.line,
                            errors ? screen.bad(harmless(diagnostic.message)) : harmless(diagnostic.message),
                            screen.dim(harmless(line_of(feedback.code, diagnostic.line))));
    }
    return text;
}

std::string groups_text(const Reference& reference, const Grade& grade, const Screen& screen) {
    std::string text;
    for (std::size_t i = 0; i < grade.groups.size(); ++i) {
        const Group& group = reference.exercise->groups[i];
        const GroupResult& result = grade.groups[i];
        const bool all = result.right == result.cases;
        const std::string points =
            fmt::format("{:>5} of {:<3} points", points_text(result.score), group.points);
        text += fmt::format("  {:<8}{}   {} of {} cases{}\n", group.name, all ? screen.good(points) : points,
                            result.right, result.cases, group.hidden ? "   (hidden)" : "");
    }
    return text;
}

/// Enough digits to see that two values differ.
int digits_apart(const Outcome& a, const Outcome& b) {
    int digits = 6;
    while (digits < 17 && text_of(a, digits) == text_of(b, digits)) ++digits;
    return digits;
}

std::string call_text(const Exercise& exercise, const Case& asked, int digits) {
    std::string arguments;
    for (const Value& value : asked.arguments)
        arguments += (arguments.empty() ? "" : ", ") + text_of(value, digits);
    return fmt::format("{}({})", exercise.functions[asked.function].name, arguments);
}

std::string case_text(const Reference& reference, const Grade& grade, std::size_t index,
                      const Screen& screen) {
    const Exercise& exercise = *reference.exercise;
    const Case& asked = reference.cases[index];
    const CaseResult& result = grade.cases[index];
    const Outcome& right = reference.outcomes[0][index];
    const int digits = digits_apart(right, result.outcome);
    std::string text =
        fmt::format("\n  {}: {}\n", exercise.groups[asked.group].name, screen.bold(asked.about));
    text += fmt::format("    asked     {}\n", call_text(exercise, asked, 17));
    text +=
        fmt::format("    expected  {}{}\n", exercise.judged ? "for example " : "", text_of(right, digits));
    text += fmt::format("    got       {}\n", screen.bad(text_of(result.outcome, digits)));
    if (!result.complaint.empty()) text += fmt::format("    but       {}\n", result.complaint);
    if (!result.outcome.printed.empty())
        text += fmt::format("    printed   {}\n", harmless(result.outcome.printed.substr(0, 300)));
    return text;
}

} // namespace

std::optional<std::size_t> told_case(const Reference& reference, const Grade& grade, bool show_hidden) {
    for (std::size_t i = 0; i < grade.cases.size(); ++i) {
        const bool hidden = reference.exercise->groups[reference.cases[i].group].hidden;
        if (!grade.cases[i].right && (show_hidden || !hidden)) return i;
    }
    return std::nullopt;
}

std::string feedback_text(const Reference& reference, const Grade& grade, const Feedback& feedback,
                          const Screen& screen) {
    const Exercise& exercise = *reference.exercise;
    const std::string file = exercise.file_name();
    std::string text = fmt::format("{}  {}\n", screen.bold(exercise.id), exercise.title);
    if (!grade.compiled) {
        text += "\n  It does not compile.\n" + diagnostics_text(grade, true, feedback, file, screen);
        if (!grade.problem.empty()) text += "\n" + wrapped(harmless(grade.problem), 2);
        if (grade.diagnostics.empty())
            for (const Function& function : exercise.functions)
                text += fmt::format("\n  expected  {}\n", function.signature);
        return text;
    }
    text += "\n" + groups_text(reference, grade, screen);
    if (grade.all_right()) return text + "\n  " + screen.good("All right.") + "\n";
    if (const auto index = told_case(reference, grade, feedback.show_hidden))
        text += case_text(reference, grade, *index, screen);
    else
        text +=
            "\n" +
            wrapped(
                "All cases that are shown are right, but hidden ones are not. They are of the kinds that the "
                "task names; their numbers are not shown.",
                2);
    if (grade.misconception)
        text += "\n  " + screen.bold("What went wrong") + "\n" +
                wrapped(exercise.misconceptions[*grade.misconception].says, 4);
    else
        text += diagnostics_text(grade, false, feedback, file, screen);
    if (feedback.ray) {
        text += fmt::format("\n  See the ray ({}):\n    {}\n", exercise.picture, feedback.ray->command);
        text += wrapped(feedback.ray->note, 4);
    }
    return text;
}

} // namespace rayscope::exercises
