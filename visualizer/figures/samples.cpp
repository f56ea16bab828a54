// An image beside the samples that each of its pixels took.

#include "visualizer/drawing/write_png.hpp"
#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/solid.hpp"

#include <cmath>
#include <map>

namespace rayscope::figures {
namespace {

constexpr Rgb pale{0xF6, 0xF7, 0xF9};

// The bluer, the more.
Rgb colour_of(double samples, double most) {
    if (!(samples > 1)) return pale;
    const double depth = samples / most;
    const auto mixed = [&](std::uint8_t from, std::uint8_t to) {
        return std::uint8_t(std::lround(from + depth * (to - from)));
    };
    return {mixed(pale.red, blue.red), mixed(pale.green, blue.green), mixed(pale.blue, blue.blue)};
}

std::vector<std::uint8_t> picture_of(const Map& samples, double most) {
    drawing::Raster raster{samples.width, samples.height, {}};
    for (const float count : samples.values) {
        const Rgb colour = colour_of(double(count), most);
        raster.bytes.insert(raster.bytes.end(), {colour.red, colour.green, colour.blue});
    }
    return drawing::png_bytes(raster);
}

} // namespace

Svg edge_samples(const Subject& subject) {
    constexpr int width = 360, height = 270;
    constexpr double shown = 490, tall = shown * height / width;
    Svg svg(1000, tall + 96);
    RenderOptions options;
    options.width = width;
    options.height = height;
    const RenderResult result = render(subject.bench, options);
    if (result.samples.values.empty())
        throw InputError(subject.bench.scene.file, {}, "a figure needs more than one sample in a pixel");
    const drawing::Area left{4, 40, shown, tall}, right{1000 - 4 - shown, 40, shown, tall};
    std::map<float, int> pixels;
    double rays = 0;
    for (const float count : result.samples.values) {
        ++pixels[count];
        rays += double(count);
    }
    const double most = double(pixels.rbegin()->first), all = double(result.samples.values.size());
    svg.image(left, png_of(result.image));
    svg.image(right, picture_of(result.samples, most));
    for (const drawing::Area& area : {left, right}) svg.frame(area, {grey, 1.5});
    svg.text({left.x + shown / 2, 20}, "the image", {21, black, true});
    svg.text({right.x + shown / 2, 20}, "samples in each pixel", {21, black, true});

    const double y = tall + 68;
    double x = right.x;
    for (const auto& [count, held] : pixels) {
        svg.rectangle({x, y - 12, 34, 24}, {colour_of(double(count), most)});
        svg.frame({x, y - 12, 34, 24}, {grey, 1.5});
        svg.text({x + 40, y}, digits(double(count), 0) + ": " + digits(100 * held / all, 0) + " %",
                 {17, black, false, Anchor::start});
        x += shown / double(pixels.size());
    }
    svg.text({left.x, y}, digits(rays / all, 1) + " samples for each pixel in the mean",
             {20, black, false, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
