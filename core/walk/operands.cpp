#include "core/walk/operands.hpp"

#include "core/scene/wording.hpp"

#include <algorithm>

namespace rayscope {
namespace {

[[noreturn]] void unknown(const ExpressionToken& token, const std::string& name) {
    std::vector<std::string_view> known;
    for (const auto& [other, entry] : fields()) known.push_back(other);
    throw WrongExpression(token.column,
                          "no field or event is called " + in_quotes(name) + did_you_mean(name, known));
}

/// Which event a word before a dot names; "ray" is the start of the ray.
std::size_t kind_named(std::string_view owner) {
    for (std::size_t kind = 0; kind < event_kinds; ++kind)
        if (owner == event_name(kind) || (kind == 0 && owner == "ray")) return kind;
    return event_kinds;
}

/// A bare name that rays have is theirs, and so are its words.
std::vector<std::string> words_of(const FieldEntry& field, std::size_t of_kind) {
    constexpr std::size_t spawned = 0;
    const bool of_ray = field.of_event[spawned] != nullptr && field.derived == nullptr;
    const std::size_t asked = of_kind == event_kinds && of_ray ? spawned : of_kind;
    std::vector<std::string> words;
    for (const auto& [kind, word] : field.words)
        if ((asked == event_kinds || kind == asked) && std::ranges::find(words, word) == words.end())
            words.emplace_back(word);
    return words;
}

} // namespace

std::string name_of(ValueType type) {
    switch (type) {
    case ValueType::condition: return "a condition";
    case ValueType::number: return "a number";
    case ValueType::colour: return "a colour";
    case ValueType::vector: return "a vector";
    case ValueType::word: return "a word";
    }
    return "";
}

FieldOperand field_operand(const ExpressionToken& token, const Vocabulary& vocabulary) {
    FieldOperand operand;
    std::string name = token.text;
    if (const auto dot = name.find('.'); dot != std::string::npos) {
        operand.of_kind = kind_named(name.substr(0, dot));
        if (operand.of_kind < event_kinds) name = name.substr(dot + 1);
    }
    if (!fields().contains(name) && name.size() > 2 && name[name.size() - 2] == '.') {
        const auto axis =
            std::min(std::string_view("xyz").find(name.back()), std::string_view("rgb").find(name.back()));
        if (axis != std::string_view::npos) {
            operand.axis = axis;
            name.resize(name.size() - 2);
        }
    }
    const auto known = fields().find(name);
    if (known == fields().end()) unknown(token, name);
    operand.field = &known->second;
    if (operand.of_kind < event_kinds && operand.field->of_event[operand.of_kind] == nullptr)
        throw WrongExpression(token.column, "the event " + std::string(event_name(operand.of_kind)) +
                                                " has no field " + in_quotes(name));
    const ValueType type = operand.field->type_of(operand.of_kind);
    if (operand.axis && type != ValueType::vector && type != ValueType::colour)
        throw WrongExpression(token.column,
                              in_quotes(name) + " is " + name_of(type) + " and has no components");
    if (name == "divergence" && !vocabulary.divergence)
        throw WrongExpression(token.column,
                              "divergence needs another run to compare with: choose it by diff first");
    return operand;
}

void check_word(const FieldEntry& field, std::size_t of_kind, const ExpressionToken& token,
                const Vocabulary& vocabulary) {
    std::vector<std::string> known = words_of(field, of_kind);
    const bool free = field.words.empty();
    if (free && field.target != Target::nothing && vocabulary.names) known = vocabulary.names(field.target);
    if (free && field.target == Target::nothing && vocabulary.materials) known = vocabulary.materials();
    if (known.empty() || token.text == "none" || std::ranges::find(known, token.text) != known.end()) return;
    constexpr std::size_t most_listed = 12;
    const std::vector<std::string_view> views(known.begin(), known.end());
    const std::string near = did_you_mean(token.text, views);
    throw WrongExpression(
        token.column,
        "unknown name " + in_quotes(token.text) +
            (near.empty() && known.size() <= most_listed ? "; expected " + one_of(views) : near));
}

} // namespace rayscope
