#include "exercises/grader/verify.hpp"

#include "core/scene/input_error.hpp"
#include "exercises/grader/grade.hpp"
#include "exercises/grader/shown_case.hpp"
#include "exercises/grader/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>

namespace rayscope::exercises {
namespace {

/// Collects what is wrong, once each.
class Problems {
public:
    void add(std::string text) {
        if (std::ranges::find(texts_, text) == texts_.end()) texts_.push_back(std::move(text));
    }
    [[nodiscard]] std::vector<std::string> texts() && { return std::move(texts_); }

private:
    std::vector<std::string> texts_;
};

std::string compile_text(const Compiled& built) {
    for (const Diagnostic& diagnostic : built.diagnostics)
        if (diagnostic.error) return fmt::format("line {}: {}", diagnostic.line, diagnostic.message);
    return built.problem;
}

/// The stub, and the misconceptions with other names, as variants of one program: what they answer is graded like a
/// student's answers.
Unit trial_unit(const Exercise& exercise) {
    std::vector<Variant> variants{{"stub.hpp", read_code(exercise.stub())}};
    for (const Misconception& wrong : exercise.misconceptions)
        variants.push_back({wrong.name + ".hpp, renamed,", renamed(read_code(wrong.file), exercise)});
    return variants_unit(exercise, variants);
}

Compiled compiled(const Toolchain& toolchain, const Unit& unit, const char* what, Problems& problems) {
    Compiled built = toolchain.kept(unit);
    if (built.program.empty())
        problems.add(fmt::format("{} does not compile: {}", what, compile_text(built)));
    return built;
}

Grade graded_variant(const Toolchain& toolchain, const Reference& reference, const Compiled& trial,
                     std::size_t variant) {
    return grade(toolchain, reference, trial, CaseRunner::Trust::none, {"answer", std::to_string(variant)});
}

void check_stub(const Toolchain& toolchain, const Reference& reference, const Compiled& trial,
                Problems& problems) {
    const Grade found = graded_variant(toolchain, reference, trial, 0);
    for (std::size_t i = 0; i < found.groups.size(); ++i)
        if (found.groups[i].right > 0)
            problems.add(fmt::format("the stub has points in group '{}' (seed {})",
                                     reference.exercise->groups[i].name, reference.seed));
}

void check_solution(const Toolchain& toolchain, const Reference& reference, const Compiled& solution,
                    CaseRunner::Trust trust, Problems& problems) {
    const Grade right = grade(toolchain, reference, solution, trust);
    for (std::size_t i = 0; i < right.cases.size(); ++i)
        if (!right.cases[i].right)
            return problems.add(fmt::format(
                "the solution is wrong in '{}' (seed {}): {} {} {}", reference.cases[i].about, reference.seed,
                text_of(right.cases[i].outcome), right.cases[i].complaint, right.cases[i].outcome.printed));
}

void check_misconception(const Toolchain& toolchain, const Reference& reference, std::size_t index,
                         const Compiled& trial, Problems& problems) {
    const Exercise& exercise = *reference.exercise;
    const Misconception& wrong = exercise.misconceptions[index];
    const Grade found = graded_variant(toolchain, reference, trial, index + 1);
    for (const std::string& name : wrong.groups) {
        const auto group =
            std::size_t(std::ranges::find(exercise.groups, name, &Group::name) - exercise.groups.begin());
        if (found.groups[group].right == found.groups[group].cases)
            problems.add(
                fmt::format("{} loses no point in group '{}' (seed {})", wrong.name, name, reference.seed));
    }
    if (!found.misconception)
        problems.add(fmt::format("{} is not recognised (seed {})", wrong.name, reference.seed));
    else if (*found.misconception != index)
        problems.add(fmt::format("{} is taken for {} (seed {})", wrong.name,
                                 exercise.misconceptions[*found.misconception].name, reference.seed));
}

/// Where there is a show(), each case has a scene that can be drawn, and the solution's ray is the tracer's.
void check_shown(const Toolchain& toolchain, const Reference& reference, const Compiled& solution,
                 Problems& problems) {
    for (std::size_t i = 0; reference.exercise->shown && i < reference.cases.size(); ++i) {
        const auto runs = shown_runs(toolchain, reference, i, reference.outcomes[0][i], solution.program);
        if (!runs)
            problems.add(fmt::format("show() makes no scene of '{}' (seed {})", reference.cases[i].about,
                                     reference.seed));
        else if (runs->parted)
            problems.add(fmt::format("the solution's ray of '{}' is not the tracer's (seed {})",
                                     reference.cases[i].about, reference.seed));
    }
}

/// No two variants of the reference may answer alike: then they could not be told apart.
void check_distinct(const Reference& reference, Problems& problems) {
    const Exercise& exercise = *reference.exercise;
    for (std::size_t a = 1; a < reference.outcomes.size(); ++a)
        for (std::size_t b = a + 1; b < reference.outcomes.size(); ++b) {
            bool alike = true;
            for (std::size_t i = 0; alike && i < reference.cases.size(); ++i)
                alike = same(reference.outcomes[a][i], reference.outcomes[b][i], exercise.tolerance);
            if (alike)
                problems.add(fmt::format("{} and {} can't be told apart (seed {})",
                                         exercise.misconceptions[a - 1].name,
                                         exercise.misconceptions[b - 1].name, reference.seed));
        }
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Names that a type, in front of them, declares.
std::set<std::string> declared_names(const std::string& code, const Exercise& exercise) {
    static const std::regex declaration(
        R"re(\b(?:double|int|bool|auto|unsigned|dvec2|dvec3|dvec4|dmat3|dmat4|Ray|Hit|Hits|Span|Spans|Box|Rect|Cam|Node|Bounce|Wall|Cross|Cell|Found|Mat|std::string|std::string_view)\s*[&*]?\s*([a-z]\w*)(?!\s*\()\b)re");
    std::set<std::string> names;
    for (std::sregex_iterator i(code.begin(), code.end(), declaration), end; i != end; ++i)
        names.insert((*i)[1]);
    for (const Function& function : exercise.functions) names.erase(function.name);
    // Members are used behind a dot, where a name is left as it is.
    static const std::regex members(R"re(struct\s+\w+\s*\{([^{}()]*)\})re");
    for (std::sregex_iterator body(code.begin(), code.end(), members), end; body != end; ++body) {
        const std::string inner = (*body)[1];
        for (std::sregex_iterator i(inner.begin(), inner.end(), declaration); i != end; ++i)
            names.erase((*i)[1]);
    }
    return names;
}

} // namespace

std::string renamed(const std::string& code, const Exercise& exercise) {
    const std::set<std::string> names = declared_names(code, exercise);
    std::string result;
    for (std::size_t i = 0; i < code.size();) {
        if (!is_word(code[i])) {
            result += code[i++];
            continue;
        }
        std::size_t end = i;
        while (end < code.size() && is_word(code[end])) ++end;
        const std::string word = code.substr(i, end - i);
        const char before = i > 0 ? code[i - 1] : ' ';
        const bool field = before == '.' || before == ':' || (before == '>' && i > 1 && code[i - 2] == '-');
        result += !field && names.contains(word) ? "other_" + word : word;
        i = end;
    }
    return result;
}

std::vector<std::string> problems_of(const Toolchain& toolchain, const Exercise& exercise,
                                     const std::vector<std::uint64_t>& seeds) {
    Problems problems;
    try {
        const Compiled trial =
            compiled(toolchain, trial_unit(exercise), "the stub, or a misconception", problems);
        const std::string code = read_code(exercise.solution());
        const Compiled solution = compiled(toolchain, answer_unit(exercise, code), "the solution", problems),
                       sanitized = compiled(toolchain, answer_unit(exercise, code, true),
                                            "the solution, under sanitizers,", problems);
        for (const std::uint64_t seed : seeds) {
            const Reference reference = make_reference(toolchain, exercise, seed);
            check_distinct(reference, problems);
            check_solution(toolchain, reference, solution, CaseRunner::Trust::none, problems);
            if (seed == seeds.front()) {
                check_solution(toolchain, reference, sanitized, CaseRunner::Trust::own_code, problems);
                check_shown(toolchain, reference, solution, problems);
            }
            if (trial.program.empty()) continue;
            check_stub(toolchain, reference, trial, problems);
            for (std::size_t i = 0; i < exercise.misconceptions.size(); ++i)
                check_misconception(toolchain, reference, i, trial, problems);
        }
    } catch (const InputError& error) {
        problems.add(error.what());
    }
    if (exercise.hints.empty()) problems.add("exercise.toml has no hints");
    return std::move(problems).texts();
}

} // namespace rayscope::exercises
