#pragma once
// What each Numbers' own file instantiates (see the folder numbers).

#include "core/extents/scan.hpp"
#include "core/tracer/tiles.hpp"
#include "core/tracer/tracer.hpp"

#include <tbb/enumerable_thread_specific.h>

namespace rayscope {

template <Numbers N>
RenderResult render(const World<N>& world, const Camera& camera, const RenderOptions& options) {
    using T = ScalarOf<N>;
    RenderResult result;
    Image& image = result.image = Image(options.width > 0 ? options.width : camera.width,
                                        options.height > 0 ? options.height : camera.height);
    const Stopwatch stopwatch;
    const Scan<N> stage(world);
    const EyeRays eye_rays(camera, image.width, image.height);
    tbb::enumerable_thread_specific<Work<T>> works;
    result.complete = for_each_tile(image.width, image.height, options, [&](const Tile& tile) {
        NullRecorder recorder;
        Tracer tracer(world, stage, works.local(), recorder);
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x)
                image.set(x, y, tracer.trace(as<T>(eye_rays.through(x + 0.5, y + 0.5))));
    });
    for (const Work<T>& work : works) result.statistics.counters += work.counters;
    result.statistics.cpu_seconds = stopwatch.cpu_seconds();
    result.statistics.wall_seconds = stopwatch.wall_seconds();
    return result;
}

template <Numbers N> Recording record(const World<N>& world, const Ray<double>& ray) {
    const Scan<N> stage(world);
    Work<ScalarOf<N>> work;
    TraceRecorder recorder;
    Tracer tracer(world, stage, work, recorder);
    const Colour colour = tracer.trace(as<ScalarOf<N>>(ray));
    return {recorder.take(), colour, recorder.dropped()};
}

} // namespace rayscope
