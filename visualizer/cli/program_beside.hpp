#pragma once
// The other programs of a build: they stand beside this one.

#include <filesystem>

namespace rayscope::cli {

[[nodiscard]] std::filesystem::path program_beside(const char* name);

} // namespace rayscope::cli
