#include "bench/stages/measured_scene.hpp"

#include "bench/support/worlds.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>

namespace rayscope::bench {
namespace {

constexpr int image_edge = 48, rays_edge = 128;
// Of so many rays one is asked of stages that test every object or its box.
constexpr std::size_t thinning = 16;
// A stage that tests everything takes minutes beyond.
constexpr std::size_t most_for_scan = 10000, most_for_extents = 10000;

struct Rung {
    const char* name;
    StageKind kind;
    std::array<bool, 3> serves; // by Rays
    std::size_t most;
    bool thin; ///< slow enough for a part of the rays
};
constexpr std::array<Rung, 6> ladder{{
    {"scan", StageKind::scan, {true, true, true}, most_for_scan, true},
    {"extents", StageKind::extents, {true, true, true}, most_for_extents, true},
    {"projective", StageKind::projective, {true, false, false}, ~std::size_t(0), false},
    {"light", StageKind::light, {false, true, false}, ~std::size_t(0), false},
    {"octree", StageKind::octree, {true, true, true}, ~std::size_t(0), false},
    {"bvh", StageKind::bvh, {true, true, true}, ~std::size_t(0), false},
}};

// What a rung does not serve goes through the bvh.
StageChoice choice_of(const Rung& rung) {
    const auto served = [&](Rays rays) {
        return rung.serves[std::size_t(rays)] ? rung.kind : StageKind::bvh;
    };
    return {served(Rays::eye), served(Rays::shadow), served(Rays::other)};
}

std::size_t bytes_of(const StageSet& stages, StageKind kind) {
    switch (kind) {
    case StageKind::octree: return stages.octree()->statistics().bytes;
    case StageKind::bvh: return stages.bvh()->statistics().bytes;
    case StageKind::projective: return stages.projective()->bytes();
    case StageKind::light: return stages.light()->bytes();
    case StageKind::scan:
    case StageKind::extents: break; // keep nothing
    }
    return 0;
}

/// @param step every so many rays one is traced
RaySum trace(const StageSet& stages, const RaySets& sets, Rays rays, std::size_t step, Work<double>& work) {
    NullRecorder recorder;
    const Leaving<double> nothing;
    RaySum sum;
    const auto add = [&](const RayUse& use, const Ray<double>& ray) {
        if (const auto hit = stages.closest(use, ray, Range<double>{0}, nothing, work, recorder)) {
            ++sum.hits;
            sum.distance += (*hit).t;
        }
    };
    switch (rays) {
    case Rays::eye:
        for (std::size_t i = 0; i < sets.eye.size(); i += step)
            add({RayKind::eye, int(i % rays_edge), int(i / rays_edge)}, sets.eye[i]);
        break;
    case Rays::other:
        for (std::size_t i = 0; i < sets.other.size(); i += step) add({RayKind::reflected}, sets.other[i]);
        break;
    case Rays::shadow:
        for (std::size_t i = 0; i < sets.shadow.size(); i += step)
            if (stages.blocked(RayUse{RayKind::shadow, none, none, 0}, sets.shadow[i], Range<double>{0, 1},
                               nothing, work, recorder))
                ++sum.hits;
        break;
    }
    return sum;
}

std::size_t count_of(const RaySets& sets, Rays rays, std::size_t step) {
    const auto& list = rays == Rays::eye ? sets.eye : rays == Rays::shadow ? sets.shadow : sets.other;
    return (list.size() + step - 1) / step;
}

std::uint64_t image_of(const Workbench& workbench, const std::optional<StageChoice>& stage) {
    RenderOptions options;
    options.width = options.height = image_edge;
    options.threads = 1;
    options.stage = stage;
    return hash(render(workbench, options).image);
}

} // namespace

std::vector<std::shared_ptr<const StageScene>> stage_scenes(const std::vector<std::string>& names,
                                                            std::size_t most) {
    std::vector<std::shared_ptr<const StageScene>> list;
    const auto add = [&](const std::string& name, bool is_cloud, const auto& make) {
        const bool asked = names.empty() || std::any_of(names.begin(), names.end(), [&](const auto& begin) {
                               return name.starts_with(begin);
                           });
        if (!asked) return;
        auto scene = std::make_shared<StageScene>(StageScene{name, is_cloud, make_workbench(make())});
        scene->workbench.scene.camera.width = scene->workbench.scene.camera.height = rays_edge;
        list.push_back(std::move(scene));
    };
    for (std::size_t count = 100; count <= most; count *= 10)
        add("cloud_" + std::to_string(count), true, [&] { return cloud(count, covering_radius(count, 2)); });
    add("flake_820", false, [] { return flake(3); });
    add("flake_7381", false, [] { return flake(4); });
    add("bowls_100", false, [] { return bowls(10); });
    add("cylinders_100", false, [] { return pierced_cylinders(10); });
    add("gears_64", false, [] { return gears(8); });
    return list;
}

std::optional<std::vector<StageRun>> register_stages(const std::shared_ptr<const StageScene>& scene) {
    const Workbench& workbench = scene->workbench;
    const World<double>& world = workbench.world;
    const Bvh<double> bvh(world);
    const auto sets = std::make_shared<const RaySets>(
        ray_sets(world, bvh, workbench.scene.camera, world.lights.front().position));
    const std::uint64_t expected = image_of(workbench, std::nullopt);
    const Screen screen{EyeRays(workbench.scene.camera, rays_edge, rays_edge), rays_edge, rays_edge};
    std::array<std::optional<RaySum>, 3> sums;
    std::vector<StageRun> runs;
    for (const Rung& rung : ladder) {
        if (world.objects.size() > rung.most) continue;
        if (image_of(workbench, choice_of(rung)) != expected) {
            std::fprintf(stderr, "%s: the image through %s differs\n", scene->name.c_str(), rung.name);
            return std::nullopt;
        }
        // It alone, so that the time to build is its own; rays that it does not serve are not asked.
        const auto stages = std::make_shared<const StageSet>(
            world,
            StageChoice{rung.kind == StageKind::light ? StageKind::scan : rung.kind,
                        rung.kind == StageKind::projective ? StageKind::scan : rung.kind,
                        rung.serves[std::size_t(Rays::other)] ? rung.kind : StageKind::scan},
            screen);
        for (const Rays rays : {Rays::eye, Rays::shadow, Rays::other}) {
            if (!rung.serves[std::size_t(rays)]) continue;
            Work<double> work;
            const RaySum sum = trace(*stages, *sets, rays, thinning, work);
            auto& known = sums[std::size_t(rays)];
            if (known && !(*known == sum)) {
                std::fprintf(stderr, "%s: %s rays through %s find something else\n", scene->name.c_str(),
                             rays_names[std::size_t(rays)], rung.name);
                return std::nullopt;
            }
            known = sum;
            StageRun run;
            run.scene = scene->name;
            run.stage = rung.name;
            run.rays = rays;
            run.is_cloud = scene->is_cloud;
            run.objects = world.objects.size();
            const std::size_t step = rung.thin ? thinning : 1;
            const double count = double(count_of(*sets, rays, step)),
                         checked = double(count_of(*sets, rays, thinning));
            run.tests = double(work.counters.objects) / checked;
            run.cells = double(work.counters.cells + work.counters.nodes + work.counters.boxes) / checked;
            run.build_seconds = stages->build_seconds();
            run.bytes = bytes_of(*stages, rung.kind);
            run.benchmark = run.title();
            benchmark::RegisterBenchmark(
                run.title().c_str(), [scene, sets, stages, rays, step, run, count](benchmark::State& state) {
                    Work<double> own;
                    for (auto _ : state) benchmark::DoNotOptimize(trace(*stages, *sets, rays, step, own));
                    state.counters["rays"] = count;
                    state.counters["tests_per_ray"] = run.tests;
                    state.counters["cells_per_ray"] = run.cells;
                    state.counters["build_ms"] = 1000 * run.build_seconds;
                    state.counters["bytes"] = double(run.bytes);
                });
            run.nanoseconds = count; // until the times are known: what to divide them by
            runs.push_back(run);
        }
    }
    return runs;
}

} // namespace rayscope::bench
