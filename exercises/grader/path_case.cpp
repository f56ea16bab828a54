#include "exercises/grader/cut_code.hpp"
#include "exercises/grader/event_case.hpp"

#include <algorithm>

namespace rayscope::exercises {
namespace {

bool is_grey(const Colour& c) { return c.x == c.y && c.y == c.z; }

/// Where a ray leaves a surface.
std::optional<EventCase> spawned(const EventPlace& place) {
    const RaySpawned& start = place.ray.start();
    if (place.ray.parent == none || !(start.left_bound > 0)) return std::nullopt;
    const auto* at = place.trace.rays[std::size_t(place.ray.parent)].find<BoundaryChosen>();
    if (at == nullptr) return std::nullopt;
    return EventCase{"7-03-spawn",
                     fmt::format("{}, {}, {}, {}", code(at->point), code(Vec3d(start.left_bound)),
                                 code(at->facing), code(start.direction))};
}

/// The coefficients of a chain of mirrors, the first ray's first; nothing if another ray is among them.
std::optional<std::vector<std::string>> coefficients_to(const EventPlace& place, double last) {
    std::vector<std::string> list{code(last)};
    for (const TracedRay* ray = &place.ray; ray->parent != none;) {
        if (ray->start().kind != RayKind::reflected) return std::nullopt;
        ray = &place.trace.rays[std::size_t(ray->parent)];
        const auto* mirrored = ray->find<Reflected>();
        if (mirrored == nullptr || !is_grey(mirrored->coefficient)) return std::nullopt;
        list.push_back(code(mirrored->coefficient.x));
    }
    std::ranges::reverse(list);
    return list;
}

std::optional<EventCase> stopped(const EventPlace& place, const NotSpawned& refused) {
    const bool counted = refused.reason == Reason::depth || refused.reason == Reason::weight ||
                         refused.reason == Reason::coefficient_zero;
    if (refused.kind != RayKind::reflected || !counted) return std::nullopt;
    const auto coefficients = coefficients_to(place, refused.coefficient);
    if (!coefficients) return std::nullopt;
    return EventCase{"3-03-stop", fmt::format("{}, {}, {}", list_code("std::vector<double>", *coefficients),
                                              place.trace.max_depth, code(place.trace.min_weight))};
}

/// What a chain of mirrors brings back, from this ray on.
std::optional<EventCase> brought(const EventPlace& place) {
    std::vector<std::string> surfaces;
    Colour background{0};
    for (const TracedRay* ray = &place.ray; ray != nullptr;) {
        if (ray->start().kind == RayKind::shadow) return std::nullopt;
        const auto* end = ray->find<RayFinished>();
        const auto* beyond = ray->find<Missed>();
        if (end == nullptr) return std::nullopt;
        if (beyond != nullptr) background = beyond->background;
        const TracedRay* next = nullptr;
        for (const int child : children_of(place.trace, *ray, RayKind::reflected))
            next = &place.trace.rays[std::size_t(child)];
        const auto* mirrored = ray->find<Reflected>();
        const bool other = !children_of(place.trace, *ray, RayKind::refracted).empty();
        if (other || (next != nullptr && (mirrored == nullptr || !is_grey(mirrored->coefficient))))
            return std::nullopt;
        if (beyond == nullptr)
            surfaces.push_back(fmt::format("{{{}, {}}}", code(end->local),
                                           code(next != nullptr ? mirrored->coefficient.x : 0)));
        ray = next;
    }
    return EventCase{"3-02-chain",
                     fmt::format("{}, {}, {}", list_code("std::vector<Bounce>", surfaces),
                                 place.trace.max_depth - place.ray.start().depth, code(background))};
}

} // namespace

std::optional<EventCase> path_case(const EventPlace& place) {
    const Event& event = place.ray.events[place.index];
    if (std::holds_alternative<RaySpawned>(event)) return spawned(place);
    if (const auto* refused = std::get_if<NotSpawned>(&event)) return stopped(place, *refused);
    if (std::holds_alternative<RayFinished>(event)) return brought(place);
    return std::nullopt;
}

} // namespace rayscope::exercises
