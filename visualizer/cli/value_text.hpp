#pragma once
// What an expression is worth, as text.

#include "visualizer/cli/numbers.hpp"

namespace rayscope::cli {

/// @param of whose value it is: angles are in degrees, and a colour of three equal parts is a grey
[[nodiscard]] std::string value_text(const Value& value, const Expression& of, const Numbers& number);

} // namespace rayscope::cli
