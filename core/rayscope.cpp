#include "core/rayscope.hpp"

#include "core/files/atomic_file.hpp"
#include "core/scene/build.hpp"
#include "core/scene/name_trace.hpp"
#include "core/substitute/substituted.hpp"
#include "core/trace/rescale.hpp"
#include "core/tracer/object_spans.hpp"
#include "core/tracer/stage_set.hpp"

#include <memory>
#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

namespace rayscope {
namespace {

template <Numbers N> World<N> world_of(const Scene& scene, const Configuration& configuration) {
    World<N> world = build<N>(scene);
    world.max_depth = configuration.max_depth;
    world.min_weight = configuration.min_weight;
    return world;
}

// The ray in the world's numbers, whatever the length of its direction; ids are the world's.
template <Scalar T, typename Record> Recording recorded(const Ray<double>& ray, const Record& record) {
    const double scale = ordinary_scale<T>(ray.direction);
    Recording recording = record(Ray<double>{ray.origin, ray.direction * scale});
    if (scale != 1) rescale(recording.rays.front(), scale);
    return recording;
}
template <Numbers N>
Recording recorded(const World<N>& world, const Ray<double>& ray,
                   const std::optional<SampleAddress>& sample) {
    return recorded<ScalarOf<N>>(ray,
                                 [&](const Ray<double>& scaled) { return record(world, scaled, sample); });
}

std::optional<SampleAddress> address_of(const TraceSource& source) {
    if (source.by_hand) return std::nullopt;
    return SampleAddress{source.x, source.y, source.sample};
}

// Objects and solids have the same ids in every World of a scene: any of them can name what was recorded.
Trace named(const Workbench& bench, const Configuration& configuration, Recording recording,
            TraceSource source) {
    Trace trace;
    trace.source = std::move(source);
    trace.source.scene = bench.scene.file;
    trace.max_depth = configuration.max_depth;
    trace.min_weight = configuration.min_weight;
    trace.eye = bench.scene.camera.eye;
    trace.rays = std::move(recording.rays);
    trace.colour = recording.colour;
    trace.events_dropped = recording.events_dropped;
    name_trace(trace, bench.scene, bench.world);
    return trace;
}

Trace traced(const Workbench& bench, const Ray<double>& ray, TraceSource source) {
    return named(bench, {{}, bench.world.max_depth, bench.world.min_weight},
                 recorded(bench.world, ray, address_of(source)), source);
}

Trace traced(const Workbench& bench, const StageSet& stages, const Ray<double>& ray, TraceSource source) {
    Recording recording = recorded<double>(ray, [&](const Ray<double>& scaled) {
        return record(bench.world, stages, scaled, address_of(source));
    });
    return named(bench, {{}, bench.world.max_depth, bench.world.min_weight}, std::move(recording),
                 std::move(source));
}

Trace traced(const Workbench& bench, const Configuration& configuration, const Ray<double>& ray,
             TraceSource source) {
    Recording recording = with_numbers(configuration.numbers, [&]<Numbers N>() {
        return recorded(world_of<N>(bench.scene, configuration), ray, address_of(source));
    });
    return named(bench, configuration, std::move(recording), std::move(source));
}

Trace traced(const Workbench& bench, const Formulas& formulas, const Ray<double>& ray, TraceSource source) {
    Recording recording = recorded<double>(
        ray, [&](const Ray<double>& scaled) { return record_with(bench.scene, formulas, scaled); });
    return named(bench, {{}, bench.world.max_depth, bench.world.min_weight}, std::move(recording),
                 std::move(source));
}

Screen screen_of(const Camera& camera, int width, int height) {
    const int columns = width > 0 ? width : camera.width, rows = height > 0 ? height : camera.height;
    return {EyeRays(camera, columns, rows), columns, rows};
}

std::pair<Ray<double>, TraceSource> through_pixel(const Camera& camera, int x, int y, int width, int height,
                                                  int sample) {
    TraceSource source;
    source.x = x;
    source.y = y;
    source.sample = sample;
    return {screen_of(camera, width, height).eye_rays.of({x, y, sample}), std::move(source)};
}

TraceSource by_hand(const Ray<double>& ray) {
    TraceSource source;
    source.by_hand = true;
    source.given_length = length(ray.direction);
    return source;
}

} // namespace

Workbench make_workbench(Scene scene) {
    World<double> world = build(scene);
    return {std::move(scene), std::move(world)};
}

Workbench open(const std::filesystem::path& path, const std::optional<std::string>& effects) {
    return make_workbench(load_scene(path, effects));
}

RenderResult render(const Workbench& bench, const RenderOptions& options) {
    return render(bench.world, bench.scene.camera, options);
}

std::function<RenderResult(const RenderOptions&)> renderer(const Scene& scene,
                                                           const Configuration& configuration) {
    return with_numbers(configuration.numbers,
                        [&]<Numbers N>() -> std::function<RenderResult(const RenderOptions&)> {
                            const auto world = std::make_shared<World<N>>(world_of<N>(scene, configuration));
                            return [world, camera = scene.camera](const RenderOptions& options) {
                                return render(*world, camera, options);
                            };
                        });
}

Configuration own_configuration(const Scene& scene) {
    return {{}, scene.limits.max_depth, scene.limits.min_weight};
}

Trace trace_pixel(const Workbench& bench, int x, int y, int width, int height, int sample) {
    auto [ray, source] = through_pixel(bench.scene.camera, x, y, width, height, sample);
    return traced(bench, ray, std::move(source));
}

Trace trace_ray(const Workbench& bench, const Ray<double>& ray) { return traced(bench, ray, by_hand(ray)); }

RenderResult render(const Workbench& bench, const Formulas& formulas, const RenderOptions& options) {
    return render_with(bench.scene, formulas, options);
}

Trace trace_pixel(const Workbench& bench, const Formulas& formulas, int x, int y, int width, int height) {
    auto [ray, source] = through_pixel(bench.scene.camera, x, y, width, height, 0);
    return traced(bench, formulas, ray, std::move(source));
}

Trace trace_ray(const Workbench& bench, const Formulas& formulas, const Ray<double>& ray) {
    return traced(bench, formulas, ray, by_hand(ray));
}

std::shared_ptr<const StageSet> make_stages(const Workbench& bench, const std::optional<StageChoice>& choice,
                                            int width, int height) {
    return std::make_shared<StageSet>(bench.world, choice ? *choice : best_choice(bench.world).choice,
                                      screen_of(bench.scene.camera, width, height));
}

std::optional<OctreeStatistics> octree_statistics(const StageSet& stages) {
    if (stages.octree() == nullptr) return std::nullopt;
    return stages.octree()->statistics();
}

Trace trace_pixel(const Workbench& bench, const StageSet& stages, int x, int y, int width, int height,
                  int sample) {
    auto [ray, source] = through_pixel(bench.scene.camera, x, y, width, height, sample);
    return traced(bench, stages, ray, std::move(source));
}

Trace trace_ray(const Workbench& bench, const StageSet& stages, const Ray<double>& ray) {
    return traced(bench, stages, ray, by_hand(ray));
}

Trace trace_pixel(const Workbench& bench, const Configuration& configuration, int x, int y, int width,
                  int height, int sample) {
    auto [ray, source] = through_pixel(bench.scene.camera, x, y, width, height, sample);
    return traced(bench, configuration, ray, std::move(source));
}

Trace trace_ray(const Workbench& bench, const Configuration& configuration, const Ray<double>& ray) {
    return traced(bench, configuration, ray, by_hand(ray));
}

Ledger ledger(const Workbench& bench, int width, int height, const std::atomic<bool>* stop) {
    const Screen screen = screen_of(bench.scene.camera, width, height);
    const StageSet stages(bench.world, best_choice(bench.world).choice, screen);
    RenderOptions options;
    options.width = screen.width;
    options.height = screen.height;
    options.stop = stop;
    const Map samples = bench.scene.camera.samples > 1 ? render(bench, options).samples : Map();
    std::vector<Ledger> rows(std::size_t(screen.height));
    tbb::parallel_for(0, screen.height, [&](int y) {
        for (int x = 0; x < screen.width && !(stop != nullptr && *stop); ++x) {
            const int taken = samples.values.empty() ? 1 : int(samples.at(x, y));
            Ledger pixel;
            for (SampleAddress sample{x, y, 0}; sample.sample < taken; ++sample.sample)
                pixel += ledger_of(record(bench.world, stages, screen.eye_rays.of(sample), sample).rays);
            rows[std::size_t(y)] += pixel /= taken;
        }
    });
    Ledger sum; // row by row: the same for any number of threads
    for (const Ledger& row : rows) sum += row;
    return sum /= double(screen.width) * screen.height;
}

ScreenExtents screen_extents(const Workbench& bench, int width, int height) {
    const Screen screen = screen_of(bench.scene.camera, width, height);
    const auto name = [&](std::uint32_t id) { return object_title(bench.scene, bench.scene.drawn[id]); };
    ScreenExtents extents;
    extents.width = screen.width;
    extents.height = screen.height;
    ScreenView view = screen_view(bench.world, screen.eye_rays, screen.width, screen.height);
    std::ranges::sort(view.rectangles, {}, &ScreenRectangle::nearest);
    for (const ScreenRectangle& r : view.rectangles)
        extents.rectangles.push_back({name(r.object), std::clamp(r.left, 0.0, double(screen.width)),
                                      std::clamp(r.top, 0.0, double(screen.height)),
                                      std::clamp(r.right, 0.0, double(screen.width)),
                                      std::clamp(r.bottom, 0.0, double(screen.height)), r.nearest});
    for (const std::uint32_t id : view.apart) extents.apart.push_back(name(id));

    const ProjectiveExtents<double> stage(bench.world, view, screen.width, screen.height);
    extents.tile = stage.tile_pixels();
    extents.entries = Map((screen.width - 1) / extents.tile + 1, (screen.height - 1) / extents.tile + 1);
    for (int y = 0; y < extents.entries.height; ++y)
        for (int x = 0; x < extents.entries.width; ++x)
            extents.entries.at(x, y) = float(stage.list_at(x * extents.tile, y * extents.tile).size());
    return extents;
}

std::vector<LightWindow> light_windows(const Workbench& bench, std::size_t light) {
    return LightExtents<double>(bench.world).windows_of(light);
}

WhyNot why_not(const Workbench& bench, const Trace& trace, std::size_t ray, std::size_t object) {
    const RaySpawned& start = trace.rays.at(ray).start();
    const SceneObject& drawn = bench.scene.drawn.at(object);
    const std::string name = object_title(bench.scene, drawn);
    const bool starts_on =
        start.left_object != none && trace.objects[std::size_t(start.left_object)].name == name;
    const auto* hit = trace.rays[ray].find<BoundaryChosen>();
    return why_not(bench.world, std::uint32_t(object), {start.origin, start.direction}, start.reach,
                   hit != nullptr ? hit->boundary.t : infinity<double>, starts_on);
}

std::optional<WhyNotCell> why_not_cell(const StageSet& stages, const Trace& trace, std::size_t ray,
                                       std::uint32_t cell) {
    if (stages.octree() == nullptr) return std::nullopt;
    const TracedRay& traced = trace.rays.at(ray);
    const RaySpawned& start = traced.start();
    const auto* hit = traced.find<BoundaryChosen>();
    return why_not_cell(*stages.octree(), {start.origin, start.direction},
                        hit != nullptr ? hit->boundary.t : start.reach, cell);
}

std::vector<Spans<double>> spans(const Workbench& bench, const Ray<double>& ray) {
    const auto narrowed = [](const SpanEnd& end) {
        return Crossing<double>{double(end.t), end.surface, end.entering};
    };
    std::vector<Spans<double>> result;
    for (std::uint32_t id = 0; id < bench.world.objects.size(); ++id) {
        Spans<double>& list = result.emplace_back();
        for (const ObjectSpan& span : object_spans(bench.world, id, ray))
            list.push_back({narrowed(span.enter), narrowed(span.exit)});
    }
    return result;
}

void write_trace(const Trace& trace, const std::filesystem::path& path) {
    if (path.extension() != ".json") throw InputError(path.string(), {}, "a trace is written as .json");
    // A scene's path may be no UTF-8, JSON must be.
    const auto text = to_json(trace).dump(1, ' ', false, nlohmann::json::error_handler_t::replace);
    write_text_file(path, text + "\n");
}

} // namespace rayscope
