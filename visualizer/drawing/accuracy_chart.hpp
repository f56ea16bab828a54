#pragma once
// What accuracy costs, as a chart: time against error, the Pareto front marked.

#include "visualizer/drawing/accuracy_file.hpp"
#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

[[nodiscard]] Raster draw_accuracy_chart(const AccuracyFile& file, const PictureSize& size);

/// A configuration's error map with its scale, which ends at `most`. Throws InputError if there is nothing in it.
[[nodiscard]] Raster draw_error_map(const ErrorMap& map, const std::string& title, double most);

/// chart.png and a picture of each error map, beside the file. Throws InputError or std::runtime_error.
void write_accuracy_pictures(const std::filesystem::path& file, const PictureSize& size);

} // namespace rayscope::drawing
