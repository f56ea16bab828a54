#pragma once
// Text within XML and HTML.

#include <string>
#include <string_view>

namespace rayscope::exercises {

/// With the characters that mean something in markup written as names, and without those that XML forbids.
[[nodiscard]] std::string escaped(std::string_view text);

} // namespace rayscope::exercises
