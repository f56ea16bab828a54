#pragma once
// A small language of conditions and numbers over the fields of events: "tir && depth >= 3", "object lens",
// "abs(theta_from - critical) < 2". Angles are in degrees, unless a number says rad.

#include "core/walk/fields.hpp"

#include <functional>
#include <memory>
#include <span>
#include <stdexcept>

namespace rayscope {

/// An expression that can't be read. what() begins with "column N: ".
struct WrongExpression : std::runtime_error {
    WrongExpression(std::size_t column, const std::string& message);
    std::size_t column; ///< in characters, from 1
};

/// What names an expression may use. A list that is not there is not checked.
struct Vocabulary {
    /// Names of objects, lights, media or generics.
    std::function<std::vector<std::string>(Target)> names;
    std::function<std::vector<std::string>()> materials;
    bool divergence = true; ///< whether there is another run to compare with
};

class Expression {
public:
    /// Throws WrongExpression.
    explicit Expression(const std::string& text, const Vocabulary& vocabulary = {});

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] ValueType type() const { return nodes_.back().type; }
    [[nodiscard]] Value value(const SeenEvent& seen) const { return value(nodes_.size() - 1, seen); }
    /// Of a condition: false where the event does not have what it asks for.
    [[nodiscard]] bool holds(const SeenEvent& seen) const;
    /// Whether it is a number of degrees.
    [[nodiscard]] bool angle() const;

    /// Whether it asks for names.
    [[nodiscard]] bool asks_for_names() const;
    /// Whether it asks for what only a stage that was asked for does; or, at all, for tests, which stages do or save.
    [[nodiscard]] bool asks_for_places() const;
    [[nodiscard]] bool asks_for_tests() const;

    enum class Operator : std::uint8_t {
        constant,
        field,
        component,
        invert,
        both,
        either,
        equal,
        unequal,
        less,
        less_equal,
        greater,
        greater_equal,
        add,
        subtract,
        multiply,
        divide,
        negate,
        absolute,
    };
    struct Node {
        Operator what = Operator::constant;
        ValueType type = ValueType::number;
        std::size_t left = 0, right = 0; ///< operands; component: right is its axis
        double number = 0;               ///< constants
        std::string word;                ///< … of words
        const FieldEntry* field = nullptr;
        std::size_t of_kind = event_kinds;
        std::size_t column = 1;
    };

private:
    [[nodiscard]] bool asks_for(std::span<const std::string_view> names) const;
    [[nodiscard]] Value value(std::size_t node, const SeenEvent& seen) const;

    std::string text_;
    std::vector<Node> nodes_; // operands before what uses them; the last one is the whole
};

} // namespace rayscope
