#include "core/tracer/stage_set.hpp"

#include "core/stage/test_cost.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace rayscope {
namespace {

// Measured: what costs a ray no more than so many balls, tested eight at a time, it tests sooner than it walks through
// anything.
constexpr double few = 16;

// Every stage tests what has no end. A compound that is asked only where the ray meets one ball costs about a generic.
double cost_of_scan(const World<double>& world) {
    double sum = 0;
    for (const Object& object : world.objects) {
        if (!object.bounds.bounded()) continue;
        const double cost = test_cost(world, object);
        sum += deciding_ball(world, object) ? std::min(cost, generic_cost) : cost;
    }
    return sum;
}

std::string text_of_distorted(const World<double>& world) {
    const auto distorted = std::ranges::count_if(world.objects, [&](const Object& object) {
        return object.bounds.bounded() && stands_apart(world, object);
    });
    if (distorted == 0) return "";
    return fmt::format("; {} {} or lie{} so far away that boxes would not hold {}: every ray tests {}",
                       distorted, distorted == 1 ? "object is so distorted" : "objects are so distorted",
                       distorted == 1 ? "s" : "", distorted == 1 ? "it" : "them",
                       distorted == 1 ? "it" : "them");
}

} // namespace

StageSet::StageSet(const World<double>& world, const StageChoice& choice, const std::optional<Screen>& screen)
    : StageBase<double, StageSet>(world), choice_(choice) {
    const auto begin = std::chrono::steady_clock::now();
    if (choice_.eye == StageKind::projective && !screen) choice_.eye = choice_.other;
    for (const StageKind kind : {choice_.eye, choice_.shadow, choice_.other}) build(kind, screen);
    build_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void StageSet::build(StageKind kind, const std::optional<Screen>& screen) {
    const auto once = [&]<typename Stage>(std::unique_ptr<Stage>& stage) {
        if (!stage) stage = std::make_unique<Stage>(world_);
    };
    switch (kind) {
    case StageKind::scan: once(scan_); break;
    case StageKind::extents: once(extents_); break;
    case StageKind::light: once(light_); break;
    case StageKind::octree:
        if (!octree_) octree_ = std::make_unique<Octree<double>>(world_, choice_.octree);
        break;
    case StageKind::bvh: once(bvh_); break;
    case StageKind::projective:
        projective_ = std::make_unique<ProjectiveExtents<double>>(
            world_, screen_view(world_, screen->eye_rays, screen->width, screen->height), screen->width,
            screen->height);
        break;
    }
}

BestChoice best_choice(const World<double>& world) {
    const std::size_t count = world.objects.size();
    const std::string objects = fmt::format("{} object{}", count, count == 1 ? "" : "s");
    const bool parts_apart = std::ranges::any_of(
        world.compounds, [](const Compound& compound) { return !compound.extents.empty(); });
    const double cost = cost_of_scan(world);
    if (cost <= few && !parts_apart)
        return {rungs.front().choice,
                objects + ": to test all of them is quicker than to look for those that matter"};
    const auto polygons = std::ranges::count_if(world.objects, [&](const Object& object) {
        return !object.is_compound &&
               std::holds_alternative<Polygon<double>>(world.solids[object.index].shape);
    });
    if (2 * std::size_t(polygons) > count)
        return {{StageKind::bvh, StageKind::bvh, StageKind::bvh},
                objects + ", mostly polygons: in boxes they are tested eight at a time, in lists one by one" +
                    text_of_distorted(world)};
    const bool mirrors = std::ranges::any_of(world.objects, [&](const Object& object) {
        const Material& material = world.material_of(object);
        return largest_component(material.reflection) > 0 || material.transmits() ||
               material.patterns != none;
    });
    const auto any_shadows_of = [&](bool area) {
        return std::ranges::any_of(world.lights, [&](const Light& light) {
            return light.shadows && light.area.is_sampled() == area;
        });
    };
    // For rays that there are none of, nothing is built.
    const bool points = any_shadows_of(false), areas = any_shadows_of(true);
    return {
        {StageKind::projective,
         points  ? StageKind::light
         : areas ? StageKind::bvh
                 : StageKind::scan,
         mirrors || areas ? StageKind::bvh : StageKind::scan},
        objects + (parts_apart ? ", with boxes around parts of a compound" : "") +
            (cost > 2 * double(count) ? fmt::format(", as dear to test as {:.0f} balls", cost) : "") +
            (points && areas ? ": the screen and each point light list what they see in every direction"
             : points        ? ": the screen and each light list what they see in every direction"
             : areas         ? ": the screen lists what it sees in every direction"
                             : ": the screen lists what it sees in every direction; no light casts shadows") +
            (areas ? "; shadow rays to areas walk through boxes" : "") +
            (mirrors ? "; mirrored and refracted rays walk through boxes" : "; nothing mirrors or refracts") +
            text_of_distorted(world)};
}

} // namespace rayscope
