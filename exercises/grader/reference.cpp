#include "exercises/grader/reference.hpp"

#include "core/files/atomic_file.hpp"
#include "core/scene/source_text.hpp"
#include "exercises/grader/units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::exercises {
namespace {

constexpr std::size_t most_kept = std::size_t(16) << 20U;

[[noreturn]] void fail(const Exercise& exercise, const std::string& message) {
    throw InputError(exercise.cases().string(), {}, message);
}

std::filesystem::path compiled(const Toolchain& toolchain, const Exercise& exercise) {
    const Compiled built = toolchain.kept(reference_unit(exercise));
    if (!built.program.empty()) return built.program;
    for (const Diagnostic& diagnostic : built.diagnostics)
        if (diagnostic.error)
            throw InputError(exercise.cases().string(), {diagnostic.line, diagnostic.column},
                             diagnostic.message);
    throw InputError(exercise.folder.string(), {},
                     "the cases, the solution and the misconceptions don't compile together: " +
                         built.problem);
}

Case read_case(const Exercise& exercise, const Value& group, const Value& about, const Value& call) {
    Case made;
    const auto& name = std::get<std::string>(group.content);
    const auto found = std::ranges::find(exercise.groups, name, &Group::name);
    if (found == exercise.groups.end())
        fail(exercise, fmt::format("a case belongs to group '{}', which exercise.toml does not have", name));
    made.group = std::size_t(found - exercise.groups.begin());
    made.about = std::get<std::string>(about.content);
    made.call = std::get<std::string>(call.content);
    auto values = decoded_sequence(made.call);
    if (!values || values->empty()) fail(exercise, "a case's arguments are no values");
    made.function = std::size_t(std::get<std::int64_t>(values->front().content));
    if (made.function >= exercise.functions.size())
        fail(exercise, fmt::format("a case calls function {}, but there are {}", made.function,
                                   exercise.functions.size()));
    made.arguments.assign(std::make_move_iterator(values->begin() + 1),
                          std::make_move_iterator(values->end()));
    return made;
}

std::vector<Case> listed(CaseRunner& runner, const Exercise& exercise, std::uint64_t seed) {
    const Outcome outcome = runner.run({{"cases", std::to_string(seed)}, ""});
    const auto* list = std::get_if<List>(&outcome.value.content);
    if (outcome.kind != OutcomeKind::answered || list == nullptr || list->size() % 3 != 0)
        fail(exercise, fmt::format("cases() of seed {} gave {} {}", seed, text_of(outcome), outcome.printed));
    std::vector<Case> cases;
    for (std::size_t i = 0; i + 2 < list->size(); i += 3)
        cases.push_back(read_case(exercise, (*list)[i], (*list)[i + 1], (*list)[i + 2]));
    // In the order of exercise.toml, whatever order they were made in.
    std::vector<Case> ordered;
    for (std::size_t group = 0; group < exercise.groups.size(); ++group)
        for (Case& made : cases)
            if (made.group == group) ordered.push_back(std::move(made));
    for (std::size_t i = 0; i < exercise.groups.size(); ++i)
        if (std::ranges::find(ordered, i, &Case::group) == ordered.end())
            fail(exercise, fmt::format("group '{}' has no case", exercise.groups[i].name));
    return ordered;
}

/// The outcomes of a case after the other, as one value: kind, detail and value of each.
std::string packed(const std::vector<Outcome>& outcomes) {
    List list;
    for (const Outcome& outcome : outcomes) {
        list.push_back({std::int64_t(outcome.kind)});
        list.push_back({std::int64_t(outcome.detail)});
        list.push_back(outcome.value);
    }
    return encoded({std::move(list)});
}

std::optional<std::vector<Outcome>> unpacked(const std::string& bytes, std::size_t count) {
    auto value = decoded(bytes);
    auto* list = value ? std::get_if<List>(&value->content) : nullptr;
    if (list == nullptr || list->size() != 3 * count) return std::nullopt;
    std::vector<Outcome> outcomes;
    for (std::size_t i = 0; i < list->size(); i += 3) {
        const auto *kind = std::get_if<std::int64_t>(&(*list)[i].content),
                   *detail = std::get_if<std::int64_t>(&(*list)[i + 1].content);
        if (kind == nullptr || detail == nullptr) return std::nullopt;
        outcomes.push_back({OutcomeKind(*kind), std::move((*list)[i + 2]), int(*detail), {}});
    }
    return outcomes;
}

/// The outcomes of a variant, kept beside the program: one that runs out of time is waited for only once.
std::vector<Outcome> outcomes_of(const Toolchain& toolchain, const Reference& reference,
                                 std::size_t variant) {
    const std::filesystem::path kept =
        fmt::format("{}.seed-{}.variant-{}", reference.program.string(), reference.seed, variant);
    if (std::filesystem::is_regular_file(kept))
        if (auto outcomes = unpacked(read_file(kept, most_kept), reference.cases.size())) return *outcomes;
    CaseRunner runner(toolchain, reference.program);
    std::vector<Outcome> outcomes;
    for (const Case& asked : reference.cases)
        outcomes.push_back(runner.run({{"answer", std::to_string(variant)}, asked.call}));
    write_text_file(kept, packed(outcomes));
    return outcomes;
}

} // namespace

Reference make_reference(const Toolchain& toolchain, const Exercise& exercise, std::uint64_t seed) {
    Reference reference;
    reference.exercise = &exercise;
    reference.seed = seed;
    reference.program = compiled(toolchain, exercise);
    CaseRunner lister(toolchain, reference.program);
    reference.cases = listed(lister, exercise, seed);
    for (std::size_t variant = 0; variant <= exercise.misconceptions.size(); ++variant)
        reference.outcomes.push_back(outcomes_of(toolchain, reference, variant));
    for (std::size_t i = 0; i < reference.cases.size(); ++i) {
        const Outcome& right = reference.outcomes[0][i];
        if (right.kind != OutcomeKind::answered)
            fail(exercise, fmt::format("the solution has no answer to '{}': {} {}", reference.cases[i].about,
                                       text_of(right), right.printed));
    }
    return reference;
}

std::string judged(CaseRunner& reference, const Case& asked, const Value& answer) {
    const Outcome outcome = reference.run({{"judge"}, asked.call + encoded(answer)});
    if (const auto* complaint = std::get_if<std::string>(&outcome.value.content);
        complaint != nullptr && outcome.kind == OutcomeKind::answered)
        return *complaint;
    return "an answer of another shape";
}

} // namespace rayscope::exercises
