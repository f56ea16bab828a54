#include "core/walk/find.hpp"

#include "core/scene/name_trace.hpp"
#include "core/tracer/stage_set.hpp"
#include "core/tracer/tiles.hpp"
#include "core/walk/timeline.hpp"

#include <atomic>

namespace rayscope {
namespace {

int count_of(const Trace& trace, const Expression& condition) {
    int count = 0;
    for (int ray = 0; std::size_t(ray) < trace.rays.size(); ++ray)
        for (int event = 0; std::size_t(event) < trace.rays[std::size_t(ray)].events.size(); ++event)
            count += condition.holds({trace, ray, event}) ? 1 : 0;
    return count;
}

} // namespace

FindResult find(const Scene& scene, const World<double>& world, const Expression& condition,
                const FindOptions& options) {
    const Camera& camera = scene.camera;
    const int width = options.render.width > 0 ? options.render.width : camera.width;
    const int height = options.render.height > 0 ? options.render.height : camera.height;
    const EyeRays eye_rays(camera, width, height);
    FindResult result;
    result.events = Map(width, height);
    // All stages give the same answers: where only answers are asked for, the quickest will do.
    std::optional<StageSet> stages;
    if (options.by_stage || !condition.asks_for_tests())
        stages.emplace(world, options.render.stage ? *options.render.stage : best_choice(world).choice,
                       Screen{eye_rays, width, height});
    const bool by_name = condition.asks_for_names();
    std::atomic<int> pixels = 0, cut = 0;
    result.complete = for_each_tile(width, height, options.render, [&](const Tile& tile) {
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x) {
                const SampleAddress sample{x, y, 0};
                const Ray<double> ray = eye_rays.of(sample);
                Recording recording =
                    stages ? record(world, *stages, ray, sample) : record(world, ray, sample);
                Trace trace;
                trace.rays = std::move(recording.rays);
                trace.max_depth = world.max_depth;
                if (by_name) name_trace(trace, scene, world);
                const int count = count_of(trace, condition);
                result.events.at(x, y) = float(count);
                pixels += count > 0 ? 1 : 0;
                cut += recording.events_dropped > 0 ? 1 : 0;
            }
    });
    result.pixels = pixels;
    result.cut = cut;
    return result;
}

std::optional<Occurrence> first_occurrence(const Trace& trace, const Expression& condition) {
    const Timeline timeline(trace);
    std::optional<Occurrence> first;
    for (std::size_t moment = 0; moment < timeline.size(); ++moment) {
        const Spot spot = timeline.at(moment);
        if (!condition.holds({trace, spot.ray, spot.event})) continue;
        if (!first) first = Occurrence{spot.ray, spot.event, 0};
        ++first->count;
    }
    return first;
}

Vocabulary vocabulary_of(const Scene& scene) {
    Vocabulary vocabulary;
    vocabulary.divergence = false;
    vocabulary.names = [&scene](Target target) {
        std::vector<std::string> names;
        const auto add_objects = [&] {
            for (const SceneObject& drawn : scene.drawn) names.push_back(object_title(scene, drawn));
        };
        switch (target) {
        case Target::object:
        case Target::object_or_none: add_objects(); break;
        case Target::light:
        case Target::light_or_none:
            for (const SceneLight& light : scene.lights) names.push_back(light.name);
            break;
        case Target::medium_or_none:
            names = {scene.medium_speed == 1 ? "air" : "surroundings"};
            add_objects();
            break;
        case Target::generic_or_none:
            for (std::size_t i = 0; i < scene.generics.size(); ++i) names.push_back(generic_title(scene, i));
            break;
        case Target::nothing: break;
        }
        return names;
    };
    vocabulary.materials = [&scene] {
        std::vector<std::string> names;
        for (const SceneMaterial& material : scene.materials) names.push_back(material.name);
        return names;
    };
    return vocabulary;
}

} // namespace rayscope
