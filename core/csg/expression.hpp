#pragma once
// Boolean expressions over named solids, as an author writes them: (outer - inner) & !mouth.
//
//     union        = intersection { ("|" | "∪") intersection }
//     intersection = negation { ("&" | "∩" | "-" | "−") negation }
//     negation     = { "!" | "¬" } ( name | "(" union ")" )
//     name         = [A-Za-z_][A-Za-z0-9_]*
//
// Both binary levels group from the left: A-B&C is (A-B)&C. Blanks and line ends may stand anywhere between.

#include "core/trace/operation.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

struct ExpressionNode {
    Operation operation = Operation::leaf;
    std::size_t left = 0, right = 0; ///< operands: earlier nodes; complement uses left only
    std::string_view name;           ///< of a leaf: a part of the text that was parsed
    std::size_t offset = 0;          ///< bytes before the name or the operator
};

/// The text is no expression: what stands at `offset` bytes, and what was expected.
class ExpressionError : public std::runtime_error {
public:
    ExpressionError(std::size_t at, const std::string& message) : std::runtime_error(message), offset(at) {}
    std::size_t offset;
};

/// Children before parents; the last node is the root. Time and memory grow linearly with the text, and neither
/// long chains nor deep parentheses use the call stack.
[[nodiscard]] std::vector<ExpressionNode> parse_expression(std::string_view text);

} // namespace rayscope
