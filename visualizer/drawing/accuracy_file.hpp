#pragma once
// A measurement as `rayscope accuracy` writes it (format rayscope-accuracy, version 1), read back to be drawn.

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::drawing {

struct MeasuredPoint {
    std::string name, scalar, method;
    int max_depth = 0;
    double min_weight = 0;
    double seconds = 0, fastest = 0, slowest = 0;
    double relative_rmse = 0;
    bool on_front = false;
    std::string map; ///< file of its error map beside the measurement; empty: none
};

struct AccuracyFile {
    std::string scene;
    int width = 0, height = 0;
    double floor = 0; ///< relative RMSE that the reference itself may be off
    std::vector<MeasuredPoint> points;
    std::vector<std::string> sentences;
};

/// Throws InputError that names the file and what was expected.
[[nodiscard]] AccuracyFile read_accuracy(const std::filesystem::path& path);

} // namespace rayscope::drawing
