#pragma once
// What an expression is worth, as text.

#include "visualizer/cli/numbers.hpp"

namespace rayscope::cli {

[[nodiscard]] std::string value_text(const Value& value, bool angle, const Numbers& number);

} // namespace rayscope::cli
