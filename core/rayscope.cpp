#include "core/rayscope.hpp"

#include "core/files/atomic_file.hpp"
#include "core/math/hash.hpp"
#include "core/scene/build.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/name_trace.hpp"
#include "core/scene/read_nff.hpp"
#include "core/scene/read_toml.hpp"
#include "core/scene/source_text.hpp"
#include "core/trace/rescale.hpp"
#include "core/tracer/object_spans.hpp"

#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>

namespace rayscope {
namespace {

template <Numbers N> World<N> world_of(const Scene& scene, const Configuration& configuration) {
    World<N> world = build<N>(scene);
    world.max_depth = configuration.max_depth;
    world.min_weight = configuration.min_weight;
    return world;
}

// The ray in the world's numbers, whatever the length of its direction; ids are the world's.
template <Numbers N> Recording recorded(const World<N>& world, const Ray<double>& ray) {
    const double scale = ordinary_scale<ScalarOf<N>>(ray.direction);
    Recording recording = record(world, {ray.origin, ray.direction * scale});
    if (scale != 1) rescale(recording.rays.front(), scale);
    return recording;
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
    return named(bench, {{}, bench.world.max_depth, bench.world.min_weight}, recorded(bench.world, ray),
                 std::move(source));
}

Trace traced(const Workbench& bench, const Configuration& configuration, const Ray<double>& ray,
             TraceSource source) {
    Recording recording = with_numbers(configuration.numbers, [&]<Numbers N>() {
        return recorded(world_of<N>(bench.scene, configuration), ray);
    });
    return named(bench, configuration, std::move(recording), std::move(source));
}

std::pair<Ray<double>, TraceSource> through_pixel(const Camera& camera, int x, int y, int width, int height) {
    const EyeRays eye_rays(camera, width > 0 ? width : camera.width, height > 0 ? height : camera.height);
    TraceSource source;
    source.x = x;
    source.y = y;
    return {eye_rays.through(x + 0.5, y + 0.5), std::move(source)};
}

TraceSource by_hand(const Ray<double>& ray) {
    TraceSource source;
    source.by_hand = true;
    source.given_length = length(ray.direction);
    return source;
}

} // namespace

Scene load_scene(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".toml") return read_toml(path);
    if (extension == ".nff") return read_nff(path);
    if (is_mesh_file(path)) return mesh_scene(path);
    throw InputError(path.string(), {}, "not a scene: its name must end in .toml, .nff, .obj or .ply");
}

Workbench make_workbench(Scene scene) {
    World<double> world = build(scene);
    return {std::move(scene), std::move(world)};
}

Workbench open(const std::filesystem::path& path) { return make_workbench(load_scene(path)); }

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

std::string content_hash(const std::filesystem::path& path) {
    const std::string text = read_file(path, std::size_t(1) << 30U);
    return fmt::format("{:016x}", Fnv1a().add(text.data(), text.size()).value());
}

Trace trace_pixel(const Workbench& bench, int x, int y, int width, int height) {
    auto [ray, source] = through_pixel(bench.scene.camera, x, y, width, height);
    return traced(bench, ray, std::move(source));
}

Trace trace_ray(const Workbench& bench, const Ray<double>& ray) { return traced(bench, ray, by_hand(ray)); }

Trace trace_pixel(const Workbench& bench, const Configuration& configuration, int x, int y, int width,
                  int height) {
    auto [ray, source] = through_pixel(bench.scene.camera, x, y, width, height);
    return traced(bench, configuration, ray, std::move(source));
}

Trace trace_ray(const Workbench& bench, const Configuration& configuration, const Ray<double>& ray) {
    return traced(bench, configuration, ray, by_hand(ray));
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
