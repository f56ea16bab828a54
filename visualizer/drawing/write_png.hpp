#pragma once
// A raster as a file.

#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

/// Complete or not at all. Throws std::runtime_error that names the file.
void write_png(const Raster& raster, const std::filesystem::path& path);

} // namespace rayscope::drawing
