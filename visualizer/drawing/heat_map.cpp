#include "visualizer/drawing/heat_map.hpp"

#include "visualizer/drawing/flat_picture.hpp"
#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rayscope::drawing {
namespace {

// Nine steps of the viridis map (Smith and van der Walt 2015, public domain): as light as the value is large.
constexpr std::array<Rgb, 9> viridis{Rgb{0x44, 0x01, 0x54}, Rgb{0x47, 0x2D, 0x7B}, Rgb{0x3B, 0x52, 0x8B},
                                     Rgb{0x2C, 0x72, 0x8E}, Rgb{0x21, 0x91, 0x8C}, Rgb{0x28, 0xAE, 0x80},
                                     Rgb{0x5E, 0xC9, 0x62}, Rgb{0xAD, 0xDC, 0x30}, Rgb{0xFD, 0xE7, 0x25}};
constexpr double text_height = 14;
constexpr int margin = 16, head = 44, bar_width = 20, bar_room = 96;

// Between 512 and 1024 pixels on the longer side, each value a square.
int enlargement(const Map& map) { return std::max(1, 1024 / std::max({map.width, map.height, 1})); }

void draw_bar(Canvas& canvas, const Area& area, double most, bool more) {
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const double bottom = area.bottom() - area.height * i / steps;
        canvas.add(
            FilledArea{{area.x, bottom - area.height / steps - 0.5, area.width, area.height / steps + 0.5},
                       heat_colour((i + 0.5) / steps)});
    }
    for (int i = 0; i <= 4; ++i)
        canvas.add(Text{{area.right() + 6, area.bottom() - area.height * i / 4},
                        (i == 4 && more ? "≥ " : "") + number(most * i / 4, 4),
                        text_height,
                        ink});
}

void copy_map(Raster& raster, const Map& map, int size, double most) {
    for (int y = 0; y < map.height * size; ++y)
        for (int x = 0; x < map.width * size; ++x) {
            const float value =
                map.values[std::size_t(y / size) * std::size_t(map.width) + std::size_t(x / size)];
            const Rgb colour = heat_colour(std::isfinite(value) ? double(value) / most : 1);
            std::uint8_t* pixel = &raster.bytes[3 * (std::size_t(head + y) * std::size_t(raster.width) +
                                                     std::size_t(margin + x))];
            pixel[0] = colour.red;
            pixel[1] = colour.green;
            pixel[2] = colour.blue;
        }
}

} // namespace

Rgb heat_colour(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (viridis.size() - 1);
    const auto below = std::min(std::size_t(place), viridis.size() - 2);
    return mixed(viridis.at(below), viridis.at(below + 1), place - double(below));
}

Raster draw_heat_map(const Map& map, const std::string& title, double most) {
    const int size = enlargement(map), width = map.width * size, height = map.height * size;
    const PictureSize whole{std::max(420, width + 2 * margin + bar_room),
                            std::max(160, height + head + margin)};
    FlatPicture picture(whole);
    Canvas canvas;
    canvas.add(Text{{double(margin), head / 2.0},
                    elided(title, Font::bold, text_height, whole.width - 2.0 * margin),
                    text_height,
                    ink,
                    Font::bold});
    draw_bar(canvas,
             {double(margin + width + 12), head + text_height, bar_width,
              std::max(40.0, height - 2 * text_height)},
             most, std::ranges::any_of(map.values, [&](float value) { return !(double(value) <= most); }));
    Raster raster = picture.finish(std::move(canvas));
    copy_map(raster, map, size, most);
    return raster;
}

double end_of_scale(const Map& map) {
    std::vector<float> values;
    std::ranges::copy_if(map.values, std::back_inserter(values), [](float v) { return std::isfinite(v); });
    if (values.empty()) return 1;
    std::ranges::sort(values);
    const auto largest = double(values.back()), usual = double(values[(values.size() - 1) * 995 / 1000]);
    constexpr double outlier = 2.5;
    const double end = largest > outlier * usual && usual > 0 ? usual : largest;
    if (!(end > 0)) return 1;
    // Numbers of things end at a multiple of four, so that a quarter of the scale is one, too.
    const bool are_whole = std::ranges::all_of(values, [](float v) { return v == std::trunc(v); });
    return are_whole && end >= 4 ? 4 * std::ceil(end / 4) : end;
}

} // namespace rayscope::drawing
