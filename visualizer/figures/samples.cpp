// An image beside the samples that each of its pixels took.

#include "visualizer/drawing/write_png.hpp"
#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/solid.hpp"

#include <algorithm>

namespace rayscope::figures {
namespace {

std::vector<std::uint8_t> picture_of(const Map& samples) {
    drawing::Raster raster{samples.width, samples.height, {}};
    for (const float count : samples.values) {
        const Rgb colour = count > 1 ? blue : Rgb{0xF6, 0xF7, 0xF9};
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
    svg.image(left, png_of(result.image));
    svg.image(right, picture_of(result.samples));
    for (const drawing::Area& area : {left, right}) svg.frame(area, {grey, 1.5});
    svg.text({left.x + shown / 2, 20}, "the image", {21, black, true});
    svg.text({right.x + shown / 2, 20}, "samples in each pixel", {21, black, true});

    const auto& counts = result.samples.values;
    const float most = *std::max_element(counts.begin(), counts.end());
    const auto more = double(std::count_if(counts.begin(), counts.end(), [](float n) { return n > 1; }));
    double rays = 0;
    for (const float n : counts) rays += double(n);
    const double y = tall + 68, pixels = double(counts.size());
    svg.rectangle({right.x, y - 12, 34, 24}, {Rgb{0xF6, 0xF7, 0xF9}});
    svg.frame({right.x, y - 12, 34, 24}, {grey, 1.5});
    svg.text({right.x + 44, y}, "1", {20, black, false, Anchor::start});
    svg.rectangle({right.x + 90, y - 12, 34, 24}, {blue});
    svg.text({right.x + 134, y},
             digits(double(most)) + ", in " + digits(100 * more / pixels, 0) + " % of the pixels",
             {20, black, false, Anchor::start});
    svg.text({left.x, y}, digits(rays / pixels, 1) + " samples for each pixel in the mean",
             {20, black, false, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
