#pragma once
// From text to the nodes of an expression.

#include "core/walk/expression.hpp"

namespace rayscope {

/// Operands before what uses them. Throws WrongExpression.
[[nodiscard]] std::vector<Expression::Node> parsed_expression(const std::string& text,
                                                              const Vocabulary& vocabulary);

} // namespace rayscope
