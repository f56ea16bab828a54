#pragma once
// What each Numbers' own file instantiates (see the folder numbers).

#include "core/tracer/antialiasing.hpp"
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
        if (stages.octree() != nullptr) statistics.octree = stages.octree()->statistics();
        return stages;
    } else {
        return Scan<N>(world);
    }
}

/// Renders by one of the tracer's two forms.
template <Numbers N, EffectMask mask> class ImageRenderer {
public:
    using T = ScalarOf<N>;

    ImageRenderer(const World<N>& world, const Camera& camera, const RenderOptions& options)
        : world_(world),
          options_(options),
          width_(options.width > 0 ? options.width : camera.width),
          height_(options.height > 0 ? options.height : camera.height),
          samples_(options.samples > 0 ? options.samples : camera.samples),
          eye_rays_(camera, width_, height_),
          stage_(stage_for(world, eye_rays_, width_, height_, options, result_.statistics)) {
        result_.image = Image(width_, height_);
        if (options.heat) result_.heat = Map(width_, height_);
    }

    [[nodiscard]] RenderResult render() {
        std::vector<FirstSeen> seen(samples_ > 1 ? std::size_t(width_) * std::size_t(height_) : 0);
        pass(options_, everywhere, [&](auto& tracer, int x, int y) {
            result_.image.set(x, y, trace(tracer, {x, y, 0}));
            if constexpr (mask == EffectMask::all)
                if (samples_ > 1) seen[index(x, y)] = tracer.first_seen();
        });
        if (samples_ > 1 && result_.complete) smooth(seen);
        if (options_.heat == Heat::samples) result_.heat = samples_ > 1 ? result_.samples : even_map(1);
        const bool is_mean = options_.maps_light() || options_.heat == Heat::dropped; // as the colour is
        if (is_mean && samples_ > 1)
            std::ranges::transform(result_.heat.values, result_.samples.values, result_.heat.values.begin(),
                                   [](float sum, float samples) { return sum / std::max(samples, 1.0F); });
        for (const Work<T>& work : works_) result_.statistics.counters += work.counters;
        result_.statistics.cpu_seconds = stopwatch_.cpu_seconds();
        result_.statistics.wall_seconds = stopwatch_.wall_seconds();
        return std::move(result_);
    }

private:
    using Stage =
        decltype(stage_for(std::declval<const World<N>&>(), std::declval<const EyeRays&>(), 0, 0,
                           std::declval<const RenderOptions&>(), std::declval<RenderStatistics&>()));
    using PixelTracer = Tracer<N, Stage, NullRecorder, DepthFirst, mask>;

    // Edges are followed for so many pixels beyond where the first samples saw them.
    static constexpr int most_rounds = 64;
    static constexpr auto everywhere = [](int, int) { return true; };

    void smooth(const std::vector<FirstSeen>& seen) {
        result_.samples = even_map(1);
        ShownImage shown(result_.image);
        Contrasts uneven = options_.even_samples ? Contrasts(seen.size(), 255) : contrasts(shown, seen);
        const EnoughSamples enough = enough_samples(uneven);
        RenderOptions silent = options_;
        silent.progress = nullptr;
        for (int round = 0; round < most_rounds && !uneven.empty() && result_.complete; ++round) {
            const auto is_uneven = [&](int x, int y) { return uneven[index(x, y)] > 0; };
            pass(round == 0 ? options_ : silent, is_uneven, [&](auto& tracer, int x, int y) {
                const RefinedPixel pixel =
                    refine(result_.image.at(x, y), uneven[index(x, y)], enough, samples_,
                           [&](int sample) { return trace(tracer, {x, y, sample}); });
                result_.image.set(x, y, pixel.colour);
                shown.set(x, y, pixel.colour);
                result_.samples.at(x, y) = float(pixel.samples);
            });
            uneven = contrasts_beside(shown, result_.samples, uneven);
        }
    }

    /// Calls pixel(tracer, x, y) for each that is wanted.
    template <typename Wanted, typename Pixel>
    void pass(const RenderOptions& options, const Wanted& wanted, const Pixel& pixel) {
        result_.complete = for_each_tile(width_, height_, options, [&](const Tile& tile) {
            NullRecorder recorder;
            Work<T>& work = works_.local();
            PixelTracer tracer(world_, stage_, work, recorder);
            if constexpr (mask == EffectMask::all) {
                if (samples_ > 1) tracer.keep_first_seen();
                if (options_.maps_light()) tracer.keep_brought();
            }
            for (int y = tile.top; y < tile.bottom; ++y) {
                for (int x = tile.left; x < tile.right; ++x) {
                    if (!wanted(x, y)) continue;
                    if (!options_.heat || is_of_trace(*options_.heat)) {
                        pixel(tracer, x, y);
                        continue;
                    }
                    const Counters before = work.counters;
                    const auto measured = [&] {
                        work.counters = before;
                        const HeatMeter meter(*options_.heat, work.counters);
                        pixel(tracer, x, y);
                        return meter.value();
                    };
                    float heat = measured();
                    // The first time, the processor's caches are cold, or another program comes between.
                    if (options_.heat == Heat::time && samples_ == 1) heat = std::min(heat, measured());
                    add_heat(x, y, heat);
                }
            }
        });
    }
    [[nodiscard]] Map even_map(float value) const {
        Map map(width_, height_);
        std::ranges::fill(map.values, value);
        return map;
    }
    void add_heat(int x, int y, float value) {
        float& heat = result_.heat.at(x, y);
        heat = options_.heat == Heat::depth ? std::max(heat, value) : heat + value;
    }
    [[nodiscard]] Colour trace(PixelTracer& tracer, const SampleAddress& sample) {
        const Colour colour = tracer.trace(as<T>(eye_rays_.of(sample)), sample);
        if (options_.heat && is_of_trace(*options_.heat))
            add_heat(sample.x, sample.y, heat_of_trace(*options_.heat, tracer));
        return colour;
    }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(width_) + std::size_t(x);
    }

    const World<N>& world_;
    const RenderOptions& options_;
    RenderResult result_;
    Stopwatch stopwatch_;
    int width_, height_, samples_;
    EyeRays eye_rays_;
    Stage stage_;
    tbb::enumerable_thread_specific<Work<T>> works_;
};

template <Numbers N, EffectMask mask>
RenderResult render_with(const World<N>& world, const Camera& camera, const RenderOptions& options) {
    return ImageRenderer<N, mask>(world, camera, options).render();
}
// In a file of its own.
extern template RenderResult render_with<double, EffectMask::all>(const World<double>&, const Camera&,
                                                                  const RenderOptions&);

/// The classic tracer is there for the numbers that images are made in; what only compares them needs one form.
template <Numbers N> inline constexpr bool has_classic_tracer = std::is_same_v<N, double>;

template <Numbers N>
RenderResult render(const World<N>& world, const Camera& camera, const RenderOptions& options) {
    if constexpr (has_classic_tracer<N>) {
        const int samples = options.samples > 0 ? options.samples : camera.samples;
        if (world.effects == EffectMask::classic && samples == 1 && !options.all_effects &&
            !options.maps_light())
            return render_with<N, EffectMask::classic>(world, camera, options);
    }
    return render_with<N, EffectMask::all>(world, camera, options);
}

template <Numbers N, typename Stage>
[[nodiscard]] Recording recorded_by(const World<N>& world, const Stage& stage, const Ray<double>& ray,
                                    const std::optional<SampleAddress>& sample) {
    Work<ScalarOf<N>> work;
    TraceRecorder recorder;
    Tracer tracer(world, stage, work, recorder);
    const auto own = as<ScalarOf<N>>(ray);
    const Colour colour = sample ? tracer.trace(own, *sample) : tracer.trace(own);
    return {recorder.take(), colour, recorder.dropped()};
}

template <Numbers N>
Recording record(const World<N>& world, const Ray<double>& ray, const std::optional<SampleAddress>& sample) {
    return recorded_by(world, Scan<N>(world), ray, sample);
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
                sample.colour = tracer.trace(ray, SampleAddress{x, top + y, 0});
                sample.lost = tracer.order().lost();
                sample.first = first_hit(world, stage, ray, works.local());
            }
        }
    });
    return samples;
}

} // namespace rayscope
