#pragma once
// POV-Ray itself, where it is installed.

#include "core/image/ssim.hpp"

#include <filesystem>

namespace rayscope::test {

[[nodiscard]] bool povray_is_installed();

/// What POV-Ray makes of the text, as a screen shows it. Fails the test, with what POV-Ray said, if it makes nothing.
[[nodiscard]] Luma render_by_povray(const std::string& text, int width, int height);

} // namespace rayscope::test
