// The hard scenes as the schoolbook's formulas in float and the stable ones in double show them.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/solid.hpp"

#include <algorithm>

namespace rayscope::figures {
namespace {

constexpr int shown_pixels = 190; // of each crop, along an edge

/// A square piece of an image, by shares of the image's width: where it begins and how wide it is.
struct Piece {
    const char* scene;
    const char* subject; ///< what the scene makes hard
    double left, top, side;
};
constexpr Piece pieces[] = {
    {"far_tiny_sphere", "balls, 3000 away", 0.12, 0.13, 0.8},
    {"grazing_light", "light along a surface", 0.355, 0.28, 0.29},
    {"cone_apexes", "both halves of a cone", 0.09, 0.42, 0.46},
    {"flush_holes", "a hole up to the face", 0.46, 0.16, 0.3},
    {"nested_glass", "thin shells of glass", 0.06, 0.06, 0.88},
    {"far_translation", "coordinates of 1000000", 0.1, 0.15, 0.52},
};

Image piece_of(const Image& image, const Piece& piece) {
    Image part(shown_pixels, shown_pixels);
    const int left = int(piece.left * image.width), top = int(piece.top * image.height);
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) part.set(x, y, image.at(left + x, top + y));
    return part;
}

} // namespace

Svg textbook_and_stable(const Subject& subject) {
    constexpr double size = 236, pair_width = 514, row = 296;
    Svg svg(1000, 44 + 3 * row);
    int place = 0;
    for (const Piece& piece : pieces) {
        const Scene scene =
            load_scene(subject.chapters / "07_accuracy" / (std::string(piece.scene) + ".toml"));
        const double x = pair_width * (place % 2) + 4, y = 44 + row * (place / 2);
        RenderOptions options;
        options.width = options.height = int(shown_pixels / piece.side);
        const Configuration stable = own_configuration(scene);
        double at = x;
        for (const Configuration& configuration : {configuration("float,textbook", stable), stable}) {
            const bool textbook = configuration.numbers.method == Method::textbook;
            const drawing::Area area{at, y, size, size};
            svg.image(area, png_of(piece_of(renderer(scene, configuration)(options).image, piece)));
            svg.frame(area, {textbook ? vermilion : blue, 3, textbook ? "9 5" : ""});
            if (place < 2)
                svg.text({at + size / 2, 24}, textbook ? "float, textbook" : "double, stable",
                         {21, textbook ? vermilion : blue, true});
            at += size + 6;
        }
        svg.text({x + size + 3, y + size + 24}, std::string(piece.scene) + ": " + piece.subject, {19});
        ++place;
    }
    return svg;
}

} // namespace rayscope::figures
