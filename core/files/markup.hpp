#pragma once
// Text within XML and HTML.

#include <string>
#include <string_view>

namespace rayscope {

/// With the characters that mean something in markup written as names, and without those that XML forbids.
[[nodiscard]] std::string in_markup(std::string_view text);

} // namespace rayscope
