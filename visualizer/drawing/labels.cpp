#include "visualizer/drawing/labels.hpp"

#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <numbers>

namespace rayscope::drawing {

double LabelPlacer::cost(const Area& area) const {
    double total = 0;
    for (const FlatSegment& stroke : strokes_) total += length_within(stroke.from, stroke.to, area);
    return total;
}

bool LabelPlacer::place(Canvas& canvas, const Label& label) {
    const double width = text_width(label.text, label.font, label.size) + 4, height = label.size * 1.25;
    Area best;
    double best_cost = infinity<double>, best_gap = 0;
    for (const double gap : {label.gap, label.gap + 12, label.gap + 26, label.gap + 44})
        for (int direction = 0; direction < 16; ++direction) {
            const double angle = direction * std::numbers::pi / 8 - std::numbers::pi / 4;
            const double x = std::cos(angle), y = std::sin(angle);
            // The label's edge, not its middle, keeps the distance.
            const Area area{label.anchor.x + x * (gap + width / 2) - width / 2,
                            label.anchor.y + y * (gap + height / 2) - height / 2, width, height};
            if (!within_.contains(area) ||
                std::ranges::any_of(taken_, [&](const Area& other) { return other.overlaps(area); }))
                continue;
            const double c = cost(area) + (gap - label.gap) * 1.1 + direction * 0.01;
            if (c < best_cost) {
                best_cost = c;
                best = area;
                best_gap = gap;
            }
        }
    if (!std::isfinite(best_cost)) return false;
    const Pixel middle{best.x + best.width / 2, best.y + best.height / 2};
    if (best_gap > label.gap) {
        const Pixel end{std::clamp(label.anchor.x, best.x, best.right()),
                        std::clamp(label.anchor.y, best.y, best.bottom())};
        canvas.add(Stroke{{label.anchor, end}, mixed(label.colour, sky, 0.45), 1});
    }
    canvas.add(FilledArea{best, paper, 0.72});
    canvas.add(Text{middle, label.text, label.size, label.colour, label.font, Align::centre});
    taken_.push_back(best);
    return true;
}

} // namespace rayscope::drawing
