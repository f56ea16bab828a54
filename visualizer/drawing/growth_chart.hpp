#pragma once
// How the time per ray grows with the number of objects, as a chart: one line for each stage.

#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

/// growth.json, as `rayscope bench stages` writes it.
struct GrowthSeries {
    std::string stage, rays;
    double exponent = 0;                           ///< not a number: none was fitted
    std::vector<std::pair<double, double>> points; ///< objects, nanoseconds a ray; at least one
};

/// Throws InputError that names the file and what was expected.
[[nodiscard]] std::vector<GrowthSeries> read_growth(const std::filesystem::path& path);

[[nodiscard]] Raster draw_growth_chart(const std::vector<GrowthSeries>& series, const PictureSize& size);

/// stages.png beside the file. Throws InputError or std::runtime_error.
void write_growth_chart(const std::filesystem::path& file, const PictureSize& size);

} // namespace rayscope::drawing
