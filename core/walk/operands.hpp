#pragma once
// What a word in an expression stands for.

#include "core/walk/expression.hpp"
#include "core/walk/tokens.hpp"

namespace rayscope {

/// "a number", "a condition", …
[[nodiscard]] std::string name_of(ValueType type);

struct FieldOperand {
    const FieldEntry* field = nullptr;
    std::size_t of_kind = event_kinds; ///< the event whose member it is, if the word says so
    std::optional<std::size_t> axis;   ///< of a vector or colour
};

/// "[event.]name[.component]", such as "weight", "point.x", "refracted.direction.z". Throws WrongExpression.
[[nodiscard]] FieldOperand field_operand(const ExpressionToken& token, const Vocabulary& vocabulary);

/// Throws WrongExpression if a field can't have that word as its value.
void check_word(const FieldEntry& field, std::size_t of_kind, const ExpressionToken& token,
                const Vocabulary& vocabulary);

} // namespace rayscope
