#pragma once
// What each Numbers' own file instantiates (see the folder numbers).

#include "core/tracer/reference_samples.hpp"
#include "core/tracer/stage_set.hpp"
#include "core/tracer/tiles.hpp"
#include "core/tracer/tracer.hpp"

#include <tuple>

#include <tbb/enumerable_thread_specific.h>

namespace rayscope {

/// Numbers other than double stable are followed to compare images of scenes that are small: they scan.
template <Numbers N>
[[nodiscard]] auto stage_for(const World<N>& world, const EyeRays& eye_rays, int width, int height,
                             const RenderOptions& options, RenderStatistics& statistics) {
    if constexpr (std::is_same_v<N, double>) {
        BestChoice best;
        if (options.stage)
            best.choice = *options.stage;
        else
            best = best_choice(world);
        StageSet stages(world, best.choice, Screen{eye_rays, width, height});
        statistics.stage = best.choice;
        statistics.stage_reason = best.reason;
        statistics.build_seconds = stages.build_seconds();
        return stages;
    } else {
        return Scan<N>(world);
    }
}

template <Numbers N>
RenderResult render(const World<N>& world, const Camera& camera, const RenderOptions& options) {
    using T = ScalarOf<N>;
    RenderResult result;
    Image& image = result.image = Image(options.width > 0 ? options.width : camera.width,
                                        options.height > 0 ? options.height : camera.height);
    const Stopwatch stopwatch;
    const EyeRays eye_rays(camera, image.width, image.height);
    const auto stage = stage_for(world, eye_rays, image.width, image.height, options, result.statistics);
    tbb::enumerable_thread_specific<Work<T>> works;
    if (options.heat) result.heat = Map(image.width, image.height);
    result.complete = for_each_tile(image.width, image.height, options, [&](const Tile& tile) {
        NullRecorder recorder;
        Work<T>& work = works.local();
        Tracer tracer(world, stage, work, recorder);
        for (int y = tile.top; y < tile.bottom; ++y) {
            for (int x = tile.left; x < tile.right; ++x) {
                std::optional<HeatMeter> meter;
                if (options.heat) meter.emplace(*options.heat, work.counters);
                image.set(x, y, tracer.trace(as<T>(eye_rays.through(x + 0.5, y + 0.5)), x, y));
                if (meter) result.heat.at(x, y) = meter->value(tracer.deepest());
            }
        }
    });
    for (const Work<T>& work : works) result.statistics.counters += work.counters;
    result.statistics.cpu_seconds = stopwatch.cpu_seconds();
    result.statistics.wall_seconds = stopwatch.wall_seconds();
    return result;
}

template <Numbers N, typename Stage>
[[nodiscard]] Recording recorded_by(const World<N>& world, const Stage& stage, const Ray<double>& ray, int x,
                                    int y) {
    Work<ScalarOf<N>> work;
    TraceRecorder recorder;
    Tracer tracer(world, stage, work, recorder);
    const Colour colour = tracer.trace(as<ScalarOf<N>>(ray), x, y);
    return {recorder.take(), colour, recorder.dropped()};
}

template <Numbers N> Recording record(const World<N>& world, const Ray<double>& ray) {
    return recorded_by(world, Scan<N>(world), ray, none, none);
}

template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] FirstHit first_hit(const World<N>& world, const Scan<N>& stage, const Ray<T>& ray,
                                 Work<T>& work) {
    NullRecorder recorder;
    const Leaving<T> nothing;
    const auto nearest = stage.closest(ray, Range<T>{T(0)}, nothing, work, recorder);
    if (!nearest) return {};
    const Interaction<N> at = interact(world, ray, nearest, nothing, none, work);
    const double t = double(at.hit.t);
    return {Id(at.hit.object), t, double(at.hit.t - T(t)), is_textbook<N> ? 0 : double(at.error_bound)};
}

template <Numbers N>
std::vector<FirstHit> first_hits(const World<N>& world, const Camera& camera, const RenderOptions& options) {
    using T = ScalarOf<N>;
    const int width = options.width > 0 ? options.width : camera.width;
    const int height = options.height > 0 ? options.height : camera.height;
    const Scan<N> stage(world);
    const EyeRays eye_rays(camera, width, height);
    std::vector<FirstHit> hits(std::size_t(width) * std::size_t(height));
    tbb::enumerable_thread_specific<Work<T>> works;
    std::ignore = for_each_tile(width, height, options, [&](const Tile& tile) {
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x)
                hits[std::size_t(y) * std::size_t(width) + std::size_t(x)] =
                    first_hit(world, stage, as<T>(eye_rays.through(x + 0.5, y + 0.5)), works.local());
    });
    return hits;
}

template <Numbers N>
std::vector<ReferenceSample> reference_samples(const World<N>& world, const EyeRays& eye_rays, int width,
                                               int top, int bottom, const RenderOptions& options) {
    using T = ScalarOf<N>;
    const Scan<N> stage(world);
    std::vector<ReferenceSample> samples(std::size_t(width) * std::size_t(bottom - top));
    tbb::enumerable_thread_specific<Work<T>> works;
    std::ignore = for_each_tile(width, bottom - top, options, [&](const Tile& tile) {
        NullRecorder recorder;
        for (int y = tile.top; y < tile.bottom; ++y) {
            for (int x = tile.left; x < tile.right; ++x) {
                const Ray<T> ray = as<T>(eye_rays.through(x + 0.5, top + y + 0.5));
                Tracer tracer(world, stage, works.local(), recorder, LargestFirst<T>());
                ReferenceSample& sample = samples[std::size_t(y) * std::size_t(width) + std::size_t(x)];
                sample.colour = tracer.trace(ray);
                sample.lost = tracer.order().lost();
                sample.first = first_hit(world, stage, ray, works.local());
            }
        }
    });
    return samples;
}

} // namespace rayscope
