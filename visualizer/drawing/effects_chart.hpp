#pragma once
// What each effect costs and changes, as a chart: a row for each, with a bar for its time and one for what it changes.

#include "visualizer/drawing/picture.hpp"

namespace rayscope::drawing {

struct MeasuredEffect {
    std::string name;
    bool called_for = false;                            ///< by the scene; else it was added to it
    double time = 1, least_time = 1, greatest_time = 1; ///< of the image with it to that without
    double difference = 0;                              ///< mean ΔE2000 between the two
};

struct EffectsFile {
    std::string scene;
    std::vector<MeasuredEffect> effects; ///< at least one
};

/// effects.json, as `rayscope explain --cost -o FOLDER` writes it. Throws InputError that names the file and what was
/// expected.
[[nodiscard]] EffectsFile read_effects(const std::filesystem::path& path);

[[nodiscard]] Raster draw_effects_chart(const EffectsFile& file, const PictureSize& size);

/// effects.png beside the file. Throws InputError or std::runtime_error.
void write_effects_chart(const std::filesystem::path& file, const PictureSize& size);

} // namespace rayscope::drawing
