#include "exercises/grader/shown_case.hpp"

#include "exercises/grader/served_formulas.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr std::chrono::seconds most_traced{10}; // a function that answers slowly holds up no class

Vec3d xyz(const Value& value) {
    const auto& fields = std::get<Record>(value.content).fields;
    const auto number = [&](std::size_t i) { return std::get<double>(fields.at(i).value.content); };
    return {number(0), number(1), number(2)};
}

/// What the exercise's show() makes of a case: `drawn` is the right value or the answer.
std::optional<ShownCase> drawn_case(CaseRunner& runner, const Case& asked, const Value& right,
                                    const Value& drawn, const Value& answer) {
    const Outcome outcome =
        runner.run({{"show"}, asked.call + encoded(right) + encoded(drawn) + encoded(answer)});
    const auto* record = std::get_if<Record>(&outcome.value.content);
    if (outcome.kind != OutcomeKind::answered || record == nullptr) return std::nullopt;
    const auto text = [&](std::size_t i) {
        return std::get<std::string>(record->fields.at(i).value.content);
    };
    const auto& ray = std::get<Record>(record->fields.at(1).value.content).fields;
    return ShownCase{text(0), "", {xyz(ray.at(0).value), xyz(ray.at(1).value)}, text(2), text(3)};
}

Trace traced(const std::string& scene, const fs::path& file, const Ray<double>& ray) {
    write_text_file(file, scene);
    return trace_ray(open(file), ray);
}

/// Nothing where the answer makes no scene, or the function gives no answer here.
std::optional<Trace> traced_yours(const Toolchain& toolchain, const Exercise& exercise,
                                  const ShownCase& shown, const fs::path& folder, const fs::path& program) {
    try {
        if (!shown.yours.empty()) return traced(shown.yours, folder / "yours.toml", shown.ray);
        if (!exercise.formula.empty())
            return trace_ray(open(folder / "right.toml"),
                             served_formulas(toolchain, exercise, program, most_traced), shown.ray);
    } catch (const std::exception&) {
        return std::nullopt; // numbers that no scene may have; a function that crashes or does not end
    }
    return std::nullopt;
}

} // namespace

std::optional<ShownCase> shown(const Toolchain& toolchain, const Reference& reference, std::size_t index,
                               const Outcome& answer) {
    if (!reference.exercise->shown) return std::nullopt;
    CaseRunner runner(toolchain, reference.program);
    const Case& asked = reference.cases[index];
    const Value& right = reference.outcomes[0][index].value;
    if (answer.kind == OutcomeKind::answered)
        if (const auto yours = drawn_case(runner, asked, right, answer.value, answer.value))
            if (auto both = drawn_case(runner, asked, right, right, answer.value)) {
                if (yours->scene != both->scene) both->yours = yours->scene;
                return both;
            }
    // An answer that can't be drawn.
    return drawn_case(runner, asked, right, right, right);
}

std::string text_of(const Ray<double>& ray) {
    const Vec3d &o = ray.origin, &d = ray.direction;
    return fmt::format("{},{},{},{},{},{}", o.x, o.y, o.z, d.x, d.y, d.z);
}

std::optional<ShownRuns> shown_runs(const Toolchain& toolchain, const Reference& reference, std::size_t index,
                                    const Outcome& answer, const fs::path& program) {
    auto found = shown(toolchain, reference, index, answer);
    if (!found) return std::nullopt;
    ShownRuns runs{std::move(*found), {}, {}, false};
    const PrivateFolder folder(toolchain.cache());
    try {
        runs.right = traced(runs.shown.scene, folder.path() / "right.toml", runs.shown.ray);
    } catch (const InputError&) {
        return std::nullopt; // numbers that no scene may have
    }
    runs.yours = traced_yours(toolchain, *reference.exercise, runs.shown, folder.path(), program);
    if (!runs.yours) runs.shown.yours.clear();
    const Precision precision = precision_of(ScalarType::float64);
    runs.parted = runs.yours && compare(runs.right, *runs.yours, precision, precision).divergence;
    return runs;
}

} // namespace rayscope::exercises
