#include "visualizer/drawing/layout.hpp"

#include "visualizer/drawing/details_panel.hpp"
#include "visualizer/drawing/legend.hpp"
#include "visualizer/drawing/timeline.hpp"
#include "visualizer/drawing/tree_panel.hpp"

#include <algorithm>

namespace rayscope::drawing {
namespace {

double scale_of(const PictureSize& size) { return std::min(size.width / 1280.0, size.height / 720.0); }
double font_of(const PictureSize& size) { return std::max(12 * scale_of(size), 10.0); }

} // namespace

std::size_t most_lanes(const PictureSize& size) {
    std::size_t lanes = 1;
    while (lanes < 12 && timeline_height(lanes + 1, font_of(size)) <= 0.34 * size.height) ++lanes;
    return lanes;
}

Layout layout_of(const PictureSize& size, const Trace& trace, int current, bool ghosts, const Lanes& lanes) {
    Layout layout;
    layout.font = font_of(size);
    layout.pixels = std::max(scale_of(size), 0.75);
    const double font = layout.font, height = size.height;
    const double side = std::min(std::max(0.285 * size.width, font * 27), 0.42 * size.width);
    const double left = size.width - side;

    layout.title = {0, 0, left, font * 2.3};
    const double strip = timeline_height(lanes.shown.size(), font);
    layout.timeline = {0, height - strip, left, strip};
    const double legend =
        draw_legend(nullptr, font, 0, left - 2 * font, trace, ghosts, font * 0.95) + font * 0.5;
    layout.legend = {0, layout.timeline.y - legend, left, legend};
    layout.view = {0, layout.title.bottom(), left, layout.legend.y - layout.title.bottom()};

    const double wanted = details_height(details_of(trace, current).size(), font);
    const double for_tree = std::min(tree_height(trace, font), 0.42 * height);
    const double details = std::min(wanted, height - for_tree);
    layout.tree = {left, 0, side, height - details};
    layout.details = {left, height - details, side, details};
    return layout;
}

} // namespace rayscope::drawing
