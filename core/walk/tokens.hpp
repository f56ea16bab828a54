#pragma once
// The words of an expression.

#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

struct ExpressionToken {
    enum class Kind : char { number, word, text, symbol, end };
    Kind kind = Kind::end;
    std::string text;       ///< of symbols the plain spelling, such as "&&" for "∧"
    double number = 0;      ///< angles with a unit: in degrees
    std::size_t column = 1; ///< in characters, from 1
};

/// The last one is the end. Throws WrongExpression.
[[nodiscard]] std::vector<ExpressionToken> tokens_of(const std::string& text);

} // namespace rayscope
