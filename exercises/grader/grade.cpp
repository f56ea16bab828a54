#include "exercises/grader/grade.hpp"

#include "exercises/grader/units.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::exercises {
namespace {

/// The misconception whose answers are these in every case.
std::optional<std::size_t> recognised(const Reference& reference, const std::vector<CaseResult>& results) {
    for (std::size_t m = 0; m < reference.exercise->misconceptions.size(); ++m) {
        bool all = true;
        for (std::size_t i = 0; all && i < results.size(); ++i)
            all = same(results[i].outcome, reference.outcomes[m + 1][i], reference.exercise->tolerance);
        if (all) return m;
    }
    return std::nullopt;
}

void count_points(const Reference& reference, Grade& result) {
    const Exercise& exercise = *reference.exercise;
    result.groups.resize(exercise.groups.size());
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        GroupResult& group = result.groups[reference.cases[i].group];
        ++group.cases;
        group.right += i < result.cases.size() && result.cases[i].right ? 1 : 0;
    }
    for (std::size_t i = 0; i < result.groups.size(); ++i) {
        GroupResult& group = result.groups[i];
        group.score = std::floor(100.0 * exercise.groups[i].points * group.right / group.cases) / 100;
        result.score += group.score;
    }
    result.score = std::round(100 * result.score) / 100;
}

} // namespace

bool Grade::all_right() const { return compiled && std::ranges::all_of(cases, &CaseResult::right); }

Grade grade(const Toolchain& toolchain, const Reference& reference, const Compiled& answers,
            CaseRunner::Trust trust, const std::vector<std::string>& words) {
    const Exercise& exercise = *reference.exercise;
    Grade result;
    result.diagnostics = answers.diagnostics;
    result.problem = answers.problem;
    result.compiled = !answers.program.empty();
    if (result.compiled) {
        CaseRunner student(toolchain, answers.program, trust), judge(toolchain, reference.program);
        for (std::size_t i = 0; i < reference.cases.size(); ++i) {
            CaseResult& verdict = result.cases.emplace_back();
            const Case& asked = reference.cases[i];
            verdict.outcome = student.run_twice({words, asked.call});
            if (verdict.outcome.kind != OutcomeKind::answered) continue;
            if (exercise.judged) {
                verdict.complaint = judged(judge, asked, verdict.outcome.value);
                verdict.right = verdict.complaint.empty();
            } else {
                verdict.right =
                    !has_nan(verdict.outcome.value) &&
                    same(verdict.outcome.value, reference.outcomes[0][i].value, exercise.tolerance);
            }
        }
        if (!result.all_right()) result.misconception = recognised(reference, result.cases);
    }
    count_points(reference, result);
    return result;
}

Grade grade(const Toolchain& toolchain, const Reference& reference, const std::string& code) {
    const PrivateFolder folder(toolchain.cache());
    return grade(toolchain, reference,
                 toolchain.compile(answer_unit(*reference.exercise, code), folder.path() / "program"));
}

} // namespace rayscope::exercises
