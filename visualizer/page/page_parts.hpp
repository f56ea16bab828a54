#pragma once
// What every page is made of; see CMakeLists.txt.

#include <string_view>

namespace rayscope::page {

extern const std::string_view html_part, style_part, script_part;

} // namespace rayscope::page
