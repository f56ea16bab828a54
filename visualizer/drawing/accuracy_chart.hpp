#pragma once
// What accuracy costs, as a chart: time against error, the Pareto front marked.

#include "visualizer/drawing/accuracy_file.hpp"
#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

[[nodiscard]] Raster draw_accuracy_chart(const AccuracyFile& file, const PictureSize& size);

/// chart.png and a picture of each error map, beside the file. Throws InputError or std::runtime_error.
void write_accuracy_pictures(const std::filesystem::path& file, const PictureSize& size);

} // namespace rayscope::drawing
