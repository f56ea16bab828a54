#pragma once
// Names beside the marks of a chart, none over another, over a mark or over the chart's line.

#include "visualizer/drawing/canvas.hpp"

#include <optional>

namespace rayscope::drawing {

struct NamedMark {
    Pixel at;
    std::string name;
    Font font = Font::sans;
    double size = 12; ///< of the letters; a mark is about as large
};

struct PlacedName {
    Area area;
    std::vector<Pixel>
        lead; ///< both ends of a thin line from the mark to the name; empty where none is needed
};

/// @param marks all that are drawn, also those that share a name
/// @param line the chart's own, which no name covers
/// @param room no name leaves it
/// @return one for each name; nothing where there is no room
[[nodiscard]] std::vector<std::optional<PlacedName>> place_names(const std::vector<NamedMark>& names,
                                                                 const std::vector<Pixel>& marks,
                                                                 const std::vector<Pixel>& line,
                                                                 const Area& room);

} // namespace rayscope::drawing
