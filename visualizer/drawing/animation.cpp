#include "visualizer/drawing/animation.hpp"

#include "visualizer/drawing/write_png.hpp"
#include "visualizer/drawing/write_webp.hpp"

#include <fmt/format.h>

namespace rayscope::drawing {
namespace {

constexpr int frame_milliseconds = 1200; // long enough to read a ray's numbers

int frames_of(const Trace& trace) {
    const auto rays = trace.rays.size();
    if (rays > std::size_t(most_frames))
        throw InputError(trace.source.scene, {},
                         fmt::format("the trace has {} rays; expected at most {} to draw one by one: choose "
                                     "another pixel, or a lower max_depth",
                                     rays, most_frames));
    return int(rays);
}

} // namespace

std::vector<std::filesystem::path> write_all_pictures(const Workbench& bench, const Trace& trace,
                                                      const std::filesystem::path& path,
                                                      const PictureSize& size) {
    const int frames = frames_of(trace), digits = int(fmt::formatted_size("{}", frames - 1));
    std::vector<std::filesystem::path> files;
    for (int ray = 0; ray < frames; ++ray) {
        const std::string name =
            fmt::format("{}-{:0{}}{}", path.stem().string(), ray, digits, path.extension().string());
        files.push_back(path.parent_path() / name);
        write_picture(bench, trace, files.back(), {size, ray});
    }
    return files;
}

void write_animation(const Workbench& bench, const Trace& trace, const std::filesystem::path& path,
                     const PictureSize& size) {
    const int frames = frames_of(trace);
    check_writable(path);
    AnimatedWebp animation(size.width, size.height);
    for (int ray = 0; ray < frames; ++ray)
        animation.add(draw_picture(bench, trace, {size, ray}), frame_milliseconds);
    write_text_file(path, animation.bytes());
}

} // namespace rayscope::drawing
