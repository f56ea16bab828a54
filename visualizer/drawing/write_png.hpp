#pragma once
// A raster as a PNG.

#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

/// Complete or not at all. Throws std::runtime_error that names the file.
void write_png(const Raster& raster, const std::filesystem::path& path);

/// The bytes of such a file, as small as they get.
[[nodiscard]] std::vector<std::uint8_t> png_bytes(const Raster& raster);

} // namespace rayscope::drawing
