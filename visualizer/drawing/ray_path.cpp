#include "visualizer/drawing/ray_path.hpp"

#include <algorithm>

namespace rayscope::drawing {
namespace {

/// The test of a dark shadow ray ends with the first opaque object in its way: the last one accepted.
const ObjectAccepted* blocker_of(const TracedRay& ray) {
    if (!is_blocked(ray)) return nullptr;
    const ObjectAccepted* last = nullptr;
    for (const Event& event : ray.events)
        if (const auto* accepted = std::get_if<ObjectAccepted>(&event)) last = accepted;
    return last;
}

template <typename Table> bool within(const Table& table, Id id) {
    return id >= 0 && std::size_t(id) < table.size();
}

} // namespace

bool is_blocked(const TracedRay& ray) {
    const auto* finished = ray.find<RayFinished>();
    return ray.start().kind == RayKind::shadow && finished != nullptr &&
           !(largest_component(finished->colour) > 0);
}

RayEnd drawn_end(const TracedRay& ray, double open_length) {
    const RaySpawned& start = ray.start();
    const Ray<double> line{start.origin, start.direction};
    if (const auto* hit = ray.find<BoundaryChosen>()) return {hit->boundary.t, hit->point, false};
    if (const auto* blocker = blocker_of(ray)) return {blocker->t, line.at(blocker->t), false};
    if (start.kind == RayKind::shadow && std::isfinite(start.reach))
        return {start.reach, line.at(start.reach), false};
    const double size = length(start.direction);
    const double t = size > 0 ? open_length / size : 0;
    return {t, line.at(t), true};
}

std::string object_name(const Trace& trace, Id object) {
    return within(trace.objects, object) ? trace.objects[std::size_t(object)].name : std::string{};
}

std::string medium_name(const Trace& trace, Id medium) {
    return within(trace.media, medium) ? trace.media[std::size_t(medium)].name : std::string{};
}

std::string target_name(const Trace& trace, const TracedRay& ray) {
    if (const auto* hit = ray.find<BoundaryChosen>()) return object_name(trace, hit->object);
    if (const auto* blocker = blocker_of(ray)) return object_name(trace, blocker->object);
    const Id light = ray.start().light;
    if (ray.start().kind == RayKind::shadow && within(trace.lights, light)) {
        const std::string& name = trace.lights[std::size_t(light)].name;
        return name.empty() ? "light" : name;
    }
    return "nothing";
}

std::vector<int> path_to(const Trace& trace, int ray) {
    std::vector<int> path;
    for (int i = ray; i != none && std::size_t(i) < trace.rays.size(); i = trace.rays[std::size_t(i)].parent)
        path.push_back(i);
    std::ranges::reverse(path);
    return path;
}

} // namespace rayscope::drawing
