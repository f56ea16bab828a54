#pragma once
// Text in XML: some letters are its own.

#include <string>
#include <string_view>

namespace rayscope::figures {

[[nodiscard]] std::string escaped(std::string_view text);

} // namespace rayscope::figures
