#pragma once
// Inside lists as bars over a line of t.

#include "visualizer/figures/sheet.hpp"

namespace rayscope::figures {

struct Lane {
    std::string name;
    List list;
    Rgb colour;
    bool name_only = false; ///< who asked draws the rest of it
};

struct Line {
    double at = 0, scale = 100; ///< page x of t = 0, page units for one unit of t
    double low = 0, high = 1;   ///< of t, what is shown
    double lane = 44;           ///< from one lane to the next
    double names = 40;          ///< page x where the lanes' names begin

    [[nodiscard]] double operator()(double t) const { return at + scale * t; }
};

/// @param y the middle of the first lane
/// @return y of the axis, below the last one
double draw_lanes(Svg& svg, const Line& line, double y, const std::vector<Lane>& lanes);

/// Two or more digits only where they are needed: "2.5", "4".
[[nodiscard]] std::string digits(double value, int decimals = 2);
[[nodiscard]] std::string in_degrees(double radians, int decimals = 1);

} // namespace rayscope::figures
