#pragma once
// Puts names beside points so that none covers another.

#include "visualizer/drawing/canvas.hpp"
#include "visualizer/drawing/ray_strokes.hpp"

namespace rayscope::drawing {

struct Label {
    std::string text;
    Pixel anchor;
    Rgb colour;
    double size = 12;
    Font font = Font::sans;
    double gap = 7; ///< pixels between the anchor and the text, at least
};

class LabelPlacer {
public:
    /// @param within no label leaves this area
    /// @param strokes lines that labels avoid to cover, where they can
    LabelPlacer(const Area& within, const std::vector<FlatSegment>& strokes)
        : within_(within), strokes_(strokes) {}

    /// Nothing may be put there any more.
    void reserve(const Area& area) { taken_.push_back(area); }
    /// Draws the label near its anchor, or not at all if there is no room. The most important come first.
    bool place(Canvas& canvas, const Label& label);

    [[nodiscard]] const std::vector<Area>& taken() const { return taken_; }

private:
    [[nodiscard]] double cost(const Area& area) const;

    Area within_;
    const std::vector<FlatSegment>& strokes_;
    std::vector<Area> taken_;
};

} // namespace rayscope::drawing
