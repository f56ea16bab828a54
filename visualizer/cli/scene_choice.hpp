#pragma once
// From what was typed to a scene file, and to a ray.

#include "visualizer/cli/options.hpp"

#include <filesystem>

namespace rayscope::cli {

/// The file of that path (no folder, unless with an extension); if there is none, the shipped scene of that name (glass_bowl for glass_bowl.toml); for
/// an empty text the glass bowl. Throws UsageError with near matches.
[[nodiscard]] std::filesystem::path find_scene(const std::string& text);

/// The scene with the effects that were asked for, if any. Throws InputError, and UsageError where those can't be read.
[[nodiscard]] Scene load_with_effects(const std::filesystem::path& path,
                                      const std::optional<std::string>& effects);

/// Traces the chosen ray. Throws UsageError if its pixel lies outside the image.
[[nodiscard]] Trace trace_choice(const Workbench& bench, const RayChoice& choice);

} // namespace rayscope::cli
