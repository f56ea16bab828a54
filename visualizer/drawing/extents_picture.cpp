#include "visualizer/drawing/extents_picture.hpp"

#include "visualizer/drawing/flat_picture.hpp"
#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <array>

namespace rayscope::drawing {
namespace {

constexpr double font = 14;
constexpr int margin = 16, head = 44, foot = 80;
constexpr std::size_t most_names = 24; // more would hide the image

constexpr Rgb tile_blue{0x20, 0x50, 0x90};

// Faded, so that lines stand out; a tile with a list is the darker the more objects that has.
Bitmap bitmap_of(const Image& image, const ScreenExtents& extents, const Area& area) {
    Bitmap bitmap{area, image.width, image.height, {}};
    bitmap.pixels.reserve(image.rgb.size() / 3);
    constexpr double faded = 0.35;
    const float longest = *std::ranges::max_element(extents.entries.values);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Rgb pixel = mixed(on_screen(image.at(x, y)), paper, faded);
            const float entries = extents.entries.at(x / extents.tile, y / extents.tile);
            const double blue = entries == 0 ? 0 : 0.10 + 0.35 * double(entries) / double(longest);
            bitmap.pixels.push_back(mixed(pixel, tile_blue, blue));
        }
    return bitmap;
}

// Screen pixels for each of the image's: up to where a small image is easy to see, and down to what a screen can hold.
double enlargement(const Image& image) {
    constexpr int wide = 640, high = 1024, most = 4096;
    const int longer = std::max(image.width, image.height);
    if (longer > most) return double(most) / longer;
    return std::max(1, std::min(wide / image.width, high / image.height));
}

class Drawer {
public:
    Drawer(Canvas& canvas, const Area& area, double scale) : canvas_(canvas), area_(area), scale_(scale) {}

    // Outlines of the tiles with a list, where they can be told apart.
    void tiles(const ScreenExtents& extents) {
        constexpr double least_edge = 6;
        constexpr std::size_t most_tiles = 100000;
        if (extents.tile * scale_ < least_edge || extents.entries.values.size() > most_tiles) return;
        for (int y = 0; y < extents.entries.height; ++y)
            for (int x = 0; x < extents.entries.width; ++x)
                if (extents.entries.at(x, y) > 0)
                    outline(at(x * extents.tile, y * extents.tile, (x + 1) * extents.tile,
                               (y + 1) * extents.tile),
                            paper, 0.5);
    }
    void rectangles(const ScreenExtents& extents) {
        for (std::size_t i = extents.rectangles.size(); i-- > 0;) {
            const auto& r = extents.rectangles[i];
            outline(at(r.left, r.top, r.right, r.bottom), lane_colour(i, false),
                    extents.rectangles.size() > 100 ? 1 : 2);
        }
        if (extents.rectangles.size() > most_names) return;
        std::vector<Area> taken;
        for (std::size_t i = 0; i < extents.rectangles.size(); ++i) {
            const auto& r = extents.rectangles[i];
            const std::string name = elided(r.name, Font::bold, font, 160);
            // Inside its upper left corner, or as much lower as others need.
            const Area corner = at(r.left, r.top, r.left, r.top);
            Area label{corner.x + 2, corner.y + 2, text_width(name, Font::bold, font) + 8, font + 6};
            const auto overlaps = [&] {
                return std::ranges::any_of(taken, [&](const Area& other) { return other.overlaps(label); });
            };
            while (overlaps() && label.bottom() + label.height < area_.bottom()) label.y += label.height;
            label.x = std::min(label.x, area_.right() - label.width);
            taken.push_back(label);
            canvas_.add(FilledArea{label, paper, 0.85});
            canvas_.add(Text{
                {label.x + 4, label.y + label.height / 2}, name, font, lane_colour(i, false), Font::bold});
        }
    }

private:
    [[nodiscard]] Area at(double left, double top, double right, double bottom) const {
        const double x = area_.x + left * scale_, y = area_.y + top * scale_;
        return {x, y, std::min(right * scale_, area_.width) - left * scale_,
                std::min(bottom * scale_, area_.height) - top * scale_};
    }
    void outline(const Area& a, Rgb colour, double width) {
        canvas_.add(
            Stroke{{{a.x, a.y}, {a.right(), a.y}, {a.right(), a.bottom()}, {a.x, a.bottom()}, {a.x, a.y}},
                   colour,
                   width});
    }

    Canvas& canvas_;
    Area area_;
    double scale_;
};

std::string apart_text(const ScreenExtents& extents) {
    if (extents.apart.empty()) return "Every object that is seen has a rectangle";
    std::string text = "Without a rectangle, in no list: ";
    for (std::size_t i = 0; i < extents.apart.size(); ++i) text += (i == 0 ? "" : ", ") + extents.apart[i];
    return text;
}

std::array<std::string, 3> summary(const ScreenExtents& extents) {
    double sum = 0;
    float most = 0;
    std::size_t empty = 0;
    for (const float entries : extents.entries.values) {
        sum += double(entries);
        most = std::max(most, entries);
        empty += entries == 0 ? 1U : 0U;
    }
    const auto tiles = extents.entries.values.size();
    const std::string size = std::to_string(extents.tile);
    return {std::to_string(extents.rectangles.size()) + " objects on the screen; " + std::to_string(tiles) +
                " tiles of " + size + " × " + size + " pixels, " + std::to_string(empty) + " of them empty",
            "A tile's list holds " + number(sum / double(tiles), 3) + " objects on average, at most " +
                number(double(most), 6) + "; the darker a tile, the longer its list",
            apart_text(extents)};
}

} // namespace

Raster draw_extents(const ScreenExtents& extents, const Image& image, const std::string& title) {
    const double scale = enlargement(image);
    const Area area{margin, head, image.width * scale, image.height * scale};
    const PictureSize size{std::max(720, int(area.width) + 2 * margin), int(area.height) + head + foot};
    FlatPicture picture(size);
    Canvas canvas;
    const double width = size.width - 2.0 * margin;
    canvas.add(Text{{double(margin), head / 2.0},
                    elided(title + ": projective extents", Font::bold, font * 1.2, width),
                    font * 1.2,
                    ink,
                    Font::bold});
    canvas.add(bitmap_of(image, extents, area));
    Drawer drawer(canvas, area, scale);
    drawer.tiles(extents);
    drawer.rectangles(extents);
    double y = area.bottom() + 1.5 * font;
    for (const std::string& line : summary(extents)) {
        canvas.add(Text{{double(margin), y}, elided(line, Font::sans, font, width), font, ink});
        y += 1.6 * font;
    }
    return picture.finish(std::move(canvas));
}

} // namespace rayscope::drawing
