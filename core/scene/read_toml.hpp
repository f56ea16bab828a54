#pragma once
// Scene files in TOML. The format: chapters/reference/scene-format.md.

#include "core/scene/scene.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace rayscope {

/// Throws InputError at the first thing that is wrong, with what was expected and the name that comes near.
[[nodiscard]] Scene read_toml(const std::filesystem::path& path);

/// The same from a text in memory; `file` is what messages call it.
[[nodiscard]] Scene parse_toml(std::string_view text, std::string file);

} // namespace rayscope
