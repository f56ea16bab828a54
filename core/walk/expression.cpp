#include "core/walk/expression.hpp"

#include "core/walk/parsed_expression.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

using Operator = Expression::Operator;

std::optional<double> number_of(const Value& value) {
    if (const auto* number = std::get_if<double>(&value)) return *number;
    if (const auto* colour = std::get_if<Vec3d>(&value)) return largest_component(*colour);
    return std::nullopt;
}

bool is_true(const Value& value) {
    const bool* condition = std::get_if<bool>(&value);
    return condition != nullptr && *condition;
}

bool is_absent(const Value& value) { return std::holds_alternative<std::monostate>(value); }

/// Of what an event does not have, neither equality nor its opposite holds.
bool equal(const Value& a, const Value& b) {
    const auto x = number_of(a), y = number_of(b);
    // A colour and a number are compared by the largest component, two colours by all.
    return a.index() != b.index() && x && y ? *x == *y : a == b;
}

bool compare(Operator what, const Value& a, const Value& b) {
    if (is_absent(a) || is_absent(b)) return false;
    if (what == Operator::equal) return equal(a, b);
    if (what == Operator::unequal) return !equal(a, b);
    const auto x = number_of(a), y = number_of(b);
    if (!x || !y) return false;
    switch (what) {
    case Operator::less: return *x < *y;
    case Operator::less_equal: return *x <= *y;
    case Operator::greater: return *x > *y;
    default: return *x >= *y;
    }
}

Value calculate(Operator what, const Value& a, const Value& b) {
    const auto x = number_of(a), y = number_of(b);
    if (!x || !y) return {};
    switch (what) {
    case Operator::add: return *x + *y;
    case Operator::subtract: return *x - *y;
    case Operator::multiply: return *x * *y;
    default: return *x / *y;
    }
}

} // namespace

WrongExpression::WrongExpression(std::size_t at, const std::string& message)
    : std::runtime_error("column " + std::to_string(at) + ": " + message), column(at) {}

Expression::Expression(const std::string& text, const Vocabulary& vocabulary)
    : text_(text), nodes_(parsed_expression(text, vocabulary)) {}

bool Expression::holds(const SeenEvent& seen) const { return is_true(value(seen)); }

bool Expression::angle() const { return nodes_.back().what == Operator::field && nodes_.back().field->angle; }

bool Expression::asks_for_names() const {
    return std::ranges::any_of(nodes_, [](const Node& node) {
        return node.what == Operator::field && node.type == ValueType::word && node.field->words.empty();
    });
}

bool Expression::asks_for(std::span<const std::string_view> names) const {
    return std::ranges::any_of(nodes_, [&](const Node& node) {
        return node.what == Operator::field && std::ranges::any_of(names, [&](std::string_view name) {
                   return node.field == &fields().find(name)->second ||
                          (node.of_kind < event_kinds && event_name(node.of_kind) == name);
               });
    });
}

bool Expression::asks_for_places() const {
    static constexpr std::string_view names[] = {
        "place_entered", "place_left", "search_began", "search_ended", "cell",   "stage",
        "place",         "level",      "held",         "low",          "high",   "t_in",
        "t_out",         "spared",     "places",       "missed",       "objects"};
    return asks_for(names);
}

bool Expression::asks_for_tests() const {
    static constexpr std::string_view names[] = {
        "object_accepted", "node_evaluated", "span_found", "cluster_merged", "tested",
        "rejected",        "count",          "node",       "enter.t",        "enter.leaf",
        "enter.face",      "enter.flipped",  "exit.t",     "exit.leaf",      "exit.face",
        "exit.flipped",    "t_first",        "t_last",     "kept",           "event"};
    return asks_for(names);
}

// As deep as the parser lets it nest; a chain of && or + is as deep as it is long, but not longer than its text.
Value Expression::value(std::size_t index, const SeenEvent& seen) const {
    const Node& node = nodes_[index];
    switch (node.what) {
    case Operator::constant:
        if (node.type == ValueType::word) return std::string_view(node.word);
        if (node.type == ValueType::condition) return node.number != 0;
        return node.number;
    case Operator::field: return value_of(*node.field, seen, node.of_kind);
    case Operator::component: {
        const Value whole = value(node.left, seen);
        if (const auto* vector = std::get_if<Vec3d>(&whole)) return (*vector)[int(node.right)];
        return whole; // a share that is one number is a grey
    }
    case Operator::invert: return !is_true(value(node.left, seen));
    case Operator::both: return is_true(value(node.left, seen)) && is_true(value(node.right, seen));
    case Operator::either: return is_true(value(node.left, seen)) || is_true(value(node.right, seen));
    case Operator::negate:
    case Operator::absolute: {
        const auto number = number_of(value(node.left, seen));
        if (!number) return {};
        return node.what == Operator::negate ? -*number : std::abs(*number);
    }
    case Operator::add:
    case Operator::subtract:
    case Operator::multiply:
    case Operator::divide: return calculate(node.what, value(node.left, seen), value(node.right, seen));
    default: return compare(node.what, value(node.left, seen), value(node.right, seen));
    }
}

} // namespace rayscope
