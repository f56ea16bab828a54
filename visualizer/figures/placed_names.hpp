#pragma once
// Names beside the marks of a chart, none over another, over a mark or over the chart's line.

#include "visualizer/figures/svg.hpp"

namespace rayscope::figures {

struct NamedMark {
    Pixel at;
    std::string name;
    Type type;
};

struct PlacedName {
    Pixel at;                 ///< the middle of the name
    Pixel lead_from, lead_to; ///< a thin line from the mark to it; equal where none is needed
};

/// @param marks all that are drawn, also those that share a name
/// @param line the chart's own, which no name covers
/// @param room no name leaves it
/// Throws InputError if a name has no place.
[[nodiscard]] std::vector<PlacedName> place_names(const std::vector<NamedMark>& names,
                                                  const std::vector<Pixel>& marks,
                                                  const std::vector<Pixel>& line, const drawing::Area& room);

} // namespace rayscope::figures
