#include "visualizer/window/image_maker.hpp"

#include "visualizer/drawing/heat_map.hpp"
#include "visualizer/window/memory.hpp"

#include <algorithm>
#include <chrono>

namespace rayscope::window {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

QImage heat_image(const Map& map, double most) {
    QImage image(map.width, map.height, QImage::Format_RGB888);
    for (int y = 0; y < map.height; ++y) {
        uchar* line = image.scanLine(y);
        for (int x = 0; x < map.width; ++x) {
            const auto value = double(map.at(x, y));
            const drawing::Rgb colour =
                drawing::heat_colour(std::isfinite(value) && most > 0 ? value / most : 1);
            *line++ = colour.red;
            *line++ = colour.green;
            *line++ = colour.blue;
        }
    }
    return image;
}

/// 8 × 8 pixels in one, then 2 × 2 where each would be long to wait for, then each.
std::vector<int> passes(double coarse_seconds) {
    constexpr double at_once = 0.15;
    if (64 * coarse_seconds < at_once) return {1};
    return {2, 1};
}

} // namespace

QImage screen_image(const Image& image) {
    QImage result(image.width, image.height, QImage::Format_RGB888);
    for (int y = 0; y < image.height; ++y) {
        uchar* line = result.scanLine(y);
        for (int x = 0; x < image.width; ++x)
            for (const std::uint8_t byte : srgb_bytes(image.at(x, y))) *line++ = byte;
    }
    return result;
}

void ImageMaker::make(std::shared_ptr<const Workbench> bench, std::optional<Heat> heat) {
    worker_.run([this, bench = std::move(bench), heat, start = Clock::now()](const std::atomic<bool>& stop) {
        const Camera& camera = bench->scene.camera;
        // The window itself needs a processor too.
        const int threads = std::max(1, int(std::thread::hardware_concurrency()) - 1);
        const auto make = [&](int coarseness) {
            RenderOptions options;
            options.width = std::max(1, (camera.width + coarseness - 1) / coarseness);
            options.height = std::max(1, (camera.height + coarseness - 1) / coarseness);
            options.samples = coarseness > 1 ? 1 : 0;
            options.threads = threads;
            options.heat = heat;
            options.stop = &stop;
            const auto began = Clock::now();
            const RenderResult result = render(*bench, options);
            if (!result.complete || stop) return infinity<double>;
            MadeImage made{{}, camera.width, camera.height, coarseness == 1, heat, 0, 0};
            if (heat) made.most = drawing::end_of_scale(result.heat);
            made.picture = heat ? heat_image(result.heat, made.most) : screen_image(result.image);
            made.seconds = since(start);
            worker_.hand_over([this, made = std::move(made)] { show_(made); });
            return since(began);
        };
        const double coarse = make(8);
        if (stop) return;
        for (const int coarseness : passes(coarse)) {
            if (!stop) (void)make(coarseness);
        }
        give_back_memory(); // of reading the scene, too: of a large one more than a hundred megabytes
    });
}

} // namespace rayscope::window
