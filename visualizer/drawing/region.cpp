#include "visualizer/drawing/region.hpp"

#include <algorithm>
#include <numeric>

namespace rayscope::drawing {
namespace {

double half_diagonal(const Box<double>& box) { return length(box.high - box.low) / 2; }
Vec3d centre_of(const Box<double>& box) { return box.low + (box.high - box.low) / 2.0; }
bool is_point_usable(const Vec3d& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

struct HitOfRay {
    const BoundaryChosen* hit;
    double weight;
};

std::vector<HitOfRay> hits_by_weight(const Trace& trace) {
    std::vector<HitOfRay> hits;
    for (const TracedRay& ray : trace.rays)
        if (const auto* hit = ray.find<BoundaryChosen>(); hit != nullptr && is_point_usable(hit->point))
            hits.push_back({hit, weight(ray)});
    std::ranges::stable_sort(hits, std::greater{}, &HitOfRay::weight);
    return hits;
}

Box<double> around(const Vec3d& point, double size) { return {point - Vec3d{size}, point + Vec3d{size}}; }

/// What there is to see around a ray that hits nothing.
Region without_hits(const Trace& trace, const Workbench& bench) {
    Box<double> all;
    for (const Object& object : bench.world.objects)
        if (object.bounds.bounded()) all = united(all, object.bounds);
    const Vec3d origin = trace.rays.empty() ? trace.eye : trace.rays.front().start().origin;
    const bool some = all.low.x <= all.high.x && half_diagonal(all) > 0;
    if (!some) return {origin, std::max(1.0, length(origin) / 4), {}};
    Region region{centre_of(all), half_diagonal(all), {}};
    const double away = length(origin - region.centre);
    // A ray that starts far from everything is shown by itself.
    if (away > 20 * region.radius) return {origin, away / 10, {}};
    return region;
}

} // namespace

Region region_of(const Trace& trace, const Workbench& bench, const std::vector<Id>& drawn) {
    const std::vector<HitOfRay> hits = hits_by_weight(trace);
    if (hits.empty()) return without_hits(trace, bench);
    const Vec3d start = trace.rays.front().start().origin;
    const double travelled = length(hits.front().hit->point - start);
    const double largest = travelled > 0 ? 4 * travelled : infinity<double>;

    Region region;
    Box<double> box;
    const auto fits = [&](const Vec3d& p) {
        return box.low.x > box.high.x ||
               length(p - centre_of(box)) < 3.5 * std::max(half_diagonal(box), travelled / 20);
    };
    std::vector<Id> seen;
    for (const auto& [hit, share] : hits) {
        const Id id = hit->object < 0 || std::size_t(hit->object) >= drawn.size()
                          ? none
                          : drawn[std::size_t(hit->object)];
        if (id == none || std::ranges::find(seen, id) != seen.end()) continue;
        seen.push_back(id);
        const Box<double>& bounds = bench.world.objects[std::size_t(id)].bounds;
        if (!bounds.bounded() || half_diagonal(bounds) > largest || !fits(centre_of(bounds))) continue;
        box = united(box, bounds);
        region.boxes.push_back(bounds);
    }
    if (box.low.x > box.high.x) box = around(hits.front().hit->point, travelled > 0 ? travelled / 4 : 1);
    const Box<double> solid = box;
    // The heavier a ray, the farther the picture reaches for its hit; the first one's is the picture's beginning.
    for (const auto& [hit, share] : hits) {
        const double reach = hit == hits.front().hit ? 6 : 1.8 + 2 * std::clamp(share, 0.0, 1.0);
        if (length(hit->point - centre_of(solid)) < reach * half_diagonal(solid)) box.include(hit->point);
    }
    region.centre = centre_of(box);
    region.radius = half_diagonal(box);
    // A grain on a large thing is shown with what it lies on.
    region.radius = std::max(region.radius, travelled / 15);
    if (!(region.radius > 0) || !std::isfinite(region.radius)) region.radius = 1;
    return region;
}

} // namespace rayscope::drawing
