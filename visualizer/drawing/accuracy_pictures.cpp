#include "visualizer/drawing/accuracy_chart.hpp"
#include "visualizer/drawing/heat_map.hpp"
#include "visualizer/drawing/write_png.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::drawing {

void write_accuracy_pictures(const std::filesystem::path& path, const PictureSize& size) {
    const AccuracyFile file = read_accuracy(path);
    const std::filesystem::path folder = path.parent_path();
    // One scale for all, so that they can be compared: it ends where a difference is plain, or at the largest.
    double most = 0;
    for (const MeasuredPoint& p : file.points)
        if (!p.map.empty())
            for (const float value : read_map(folder / p.map).values)
                if (std::isfinite(value)) most = std::max(most, double(value));
    constexpr double plain = 10;
    most = most > 0 ? std::min(most, plain) : 1;
    write_png(draw_accuracy_chart(file, size), folder / "chart.png");
    for (const MeasuredPoint& p : file.points)
        if (!p.map.empty())
            write_png(draw_heat_map(read_map(folder / p.map),
                                    p.name + ": ΔE2000 against the reference (1 is just visible)", most),
                      (folder / p.map).replace_extension(".png"));
}

} // namespace rayscope::drawing
