#pragma once
// Scene files in NFF, the Neutral File Format of the Standard Procedural Databases (Haines 1987). What is taken from
// it and how: chapters/reference/scene-format.md.

#include "core/scene/scene.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace rayscope {

/// Throws InputError where the file breaks the grammar. What is only odd (a sphere of radius 0, a polygon without
/// area) is left out, with a warning in the scene.
[[nodiscard]] Scene read_nff(const std::filesystem::path& path);

/// The same from a text in memory; `file` is what messages call it.
[[nodiscard]] Scene parse_nff(std::string_view text, std::string file);

} // namespace rayscope
