#pragma once
// The program that draws, rayscope-view: it stands beside this one where VTK was found.

#include "visualizer/cli/options.hpp"

#include <filesystem>

namespace rayscope::cli {

/// False in a build without VTK.
[[nodiscard]] bool can_draw();

/// One line on how to get it.
[[nodiscard]] const char* how_to_draw();

/// What rayscope-view makes of a trace.
enum class Drawing {
    png,
    pngs, ///< one for each ray: the file's name gets a number; their names go to stdout
    webp, ///< the same as an animation
    vtm
};

/// Has a trace drawn, and waits for it. The program's own messages go to stderr. Throws std::runtime_error if it fails.
/// @param ray of a picture: the ray in front; none: all alike
void draw(Drawing drawing, const Trace& trace, const std::filesystem::path& output,
          std::optional<Size> size = {}, int ray = none);

/// Has a map drawn with its scale. Throws std::runtime_error.
void draw_heat(const Map& map, const std::string& title, const std::filesystem::path& output);

/// Has a scene's projective extents drawn over its image. Throws std::runtime_error.
void draw_extents(const std::filesystem::path& scene, const std::filesystem::path& output,
                  std::optional<Size> size);

/// Has the chart and the error maps of a measurement drawn, beside its accuracy.json. Throws std::runtime_error.
void draw_accuracy(const std::filesystem::path& json);

/// Has the chart of what effects cost drawn, beside its effects.json. Throws std::runtime_error.
void draw_effects(const std::filesystem::path& json);

} // namespace rayscope::cli
