#include "visualizer/figures/lanes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayscope::figures {

double draw_lanes(Svg& svg, const Line& line, double y, const std::vector<Lane>& lanes) {
    const double axis = y + line.lane * double(lanes.size());
    for (const Lane& lane : lanes) {
        svg.text({line.names, y}, lane.name, {22, black, true, Anchor::start});
        if (lane.name_only) {
            y += line.lane;
            continue;
        }
        svg.line({line(line.low), y}, {line(line.high), y}, {pale, 2});
        if (lane.list.empty()) svg.text({line((line.low + line.high) / 2), y}, "empty", {18, grey});
        for (const auto& [enter, exit] : lane.list) {
            const double from = line(std::max(enter, line.low)), to = line(std::min(exit, line.high));
            svg.rectangle({from, y - 8, to - from, 16}, {lane.colour, 0.85});
            if (enter >= line.low) svg.line({from, y - 14}, {from, y + 14}, {black, 2.5});
            if (exit <= line.high) svg.line({to, y - 14}, {to, y + 14}, {black, 2.5});
        }
        y += line.lane;
    }
    svg.arrow({line(line.low), axis}, {line(line.high) + 14, axis}, {black, 2});
    svg.text({line(line.high) + 30, axis}, "t", {22, black, true});
    for (double t = std::ceil(line.low); t <= line.high - 0.2; t += 1) {
        svg.line({line(t), axis - 6}, {line(t), axis + 6}, {black, 2});
        svg.text({line(t), axis + 22}, digits(t), {18, grey});
    }
    return axis;
}

std::string digits(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    if (text == "-0") text = "0";
    if (text.front() == '-') text = "−" + text.substr(1);
    return text;
}

std::string in_degrees(double radians, int decimals) {
    return digits(radians * 180 / std::numbers::pi, decimals) + "°";
}

} // namespace rayscope::figures
