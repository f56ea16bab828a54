#include "exercises/grader/results.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

namespace rayscope::exercises {
namespace {

/// Quoted where that is needed; a spreadsheet must not take it for a formula.
std::string field(std::string text) {
    if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos)
        text = "'" + text;
    if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

std::string verdict(const ExerciseMark& exercise) {
    if (!exercise.handed_in) return "not handed in";
    if (!exercise.compiled) return "does not compile";
    return exercise.misconception;
}

/// Pearson's; nothing where one of the two never changes.
std::optional<double> correlation(const std::vector<double>& x, const std::vector<double>& y) {
    const auto count = double(x.size());
    double sum_x = 0, sum_y = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum_x += x[i], sum_y += y[i];
    double xx = 0, yy = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double dx = x[i] - sum_x / count, dy = y[i] - sum_y / count;
        xx += dx * dx, yy += dy * dy, xy += dx * dy;
    }
    if (!(xx > 0) || !(yy > 0)) return std::nullopt;
    return xy / std::sqrt(xx * yy);
}

struct Item {
    const ExerciseMark* exercise;
    const GroupMark* group;
    std::vector<double> share, rest; ///< of each student: of this group's points; points in all others
};

std::string item_line(const Item& item, const std::map<std::string, int>& misconceptions) {
    double sum = 0;
    for (const double share : item.share) sum += share;
    const auto discrimination = correlation(item.share, item.rest);
    std::string found;
    for (const auto& [name, count] : misconceptions)
        found += fmt::format("{}{}: {}", found.empty() ? "" : "; ", name, count);
    return fmt::format("{},{},{},{},{},{:.3f},{},{}\n", item.exercise->id, item.group->name,
                       item.group->hidden ? "yes" : "no", item.group->points, item.share.size(),
                       sum / double(item.share.size()),
                       discrimination ? fmt::format("{:.3f}", *discrimination) : "", field(found));
}

} // namespace

std::string class_csv(const std::vector<SubmissionMark>& marks) {
    std::string text = "student,score,points";
    if (!marks.empty())
        for (const ExerciseMark& exercise : marks.front().exercises)
            text += fmt::format(",{0},{0} remark", exercise.id);
    text += "\n";
    for (const SubmissionMark& mark : marks) {
        text += fmt::format("{},{},{}", field(mark.student), mark.score, mark.points);
        for (const ExerciseMark& exercise : mark.exercises)
            text += fmt::format(",{},{}", exercise.score, field(verdict(exercise)));
        text += "\n";
    }
    return text;
}

std::string items_csv(const std::vector<SubmissionMark>& marks) {
    std::string text = "exercise,group,hidden,points,students,difficulty,discrimination,misconceptions\n";
    if (marks.empty()) return text;
    for (std::size_t e = 0; e < marks.front().exercises.size(); ++e) {
        std::map<std::string, int> misconceptions;
        for (const SubmissionMark& mark : marks)
            if (!mark.exercises[e].misconception.empty()) ++misconceptions[mark.exercises[e].misconception];
        for (std::size_t g = 0; g < marks.front().exercises[e].groups.size(); ++g) {
            Item item{&marks.front().exercises[e], &marks.front().exercises[e].groups[g], {}, {}};
            for (const SubmissionMark& mark : marks) {
                const double score = mark.exercises[e].groups[g].score;
                item.share.push_back(score / item.group->points);
                item.rest.push_back(mark.score - score);
            }
            text += item_line(item, misconceptions);
        }
    }
    return text;
}

} // namespace rayscope::exercises
