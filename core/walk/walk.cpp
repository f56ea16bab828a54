#include "core/walk/walk.hpp"

namespace rayscope {
namespace {

template <typename E> std::optional<int> event_of(const TracedRay& ray, Id light = none) {
    for (std::size_t i = 0; i < ray.events.size(); ++i) {
        const E* event = std::get_if<E>(&ray.events[i]);
        if (event == nullptr) continue;
        if constexpr (std::is_same_v<E, LightLit>)
            if (light != none && event->light != light) continue;
        return int(i);
    }
    return std::nullopt;
}

template <typename E> std::optional<int> refused(const TracedRay& ray, RayKind kind) {
    for (std::size_t i = 0; i < ray.events.size(); ++i)
        if (const E* event = std::get_if<E>(&ray.events[i]); event && event->kind == kind) return int(i);
    return std::nullopt;
}

std::optional<int> node_of(const Trace& trace, const TracedRay& ray, const Difference& difference) {
    for (std::size_t i = 0; i < ray.events.size(); ++i)
        if (const auto* node = std::get_if<NodeEvaluated>(&ray.events[i]))
            if (node->node == difference.node &&
                trace.objects[std::size_t(node->object)].name == difference.object)
                return int(i);
    return std::nullopt;
}

std::optional<int> hit_of(const TracedRay& ray) {
    const auto hit = event_of<BoundaryChosen>(ray);
    return hit ? hit : event_of<Missed>(ray);
}

std::optional<int> way_on(const TracedRay& ray, RayKind kind) {
    if (const auto not_followed = refused<NotSpawned>(ray, kind)) return not_followed;
    return kind == RayKind::refracted ? event_of<Refracted>(ray) : event_of<Reflected>(ray);
}

std::optional<int> event_of(const Trace& trace, const TracedRay& ray, const Difference& difference) {
    switch (difference.answer) {
    case Answer::spans: return node_of(trace, ray, difference);
    case Answer::media:
    case Answer::hit:
    case Answer::object:
    case Answer::face:
    case Answer::side:
    case Answer::t:
    case Answer::normal: return hit_of(ray);
    case Answer::local_light:
    case Answer::shadow_ray:
    case Answer::cosine:
    case Answer::mirror_cosine: {
        const auto lit = event_of<LightLit>(ray, difference.light);
        return lit ? lit : event_of<LocalLightSkipped>(ray);
    }
    case Answer::total: {
        const auto total = event_of<TotallyReflected>(ray);
        return total ? total : event_of<Refracted>(ray);
    }
    case Answer::followed:
    case Answer::share:
    case Answer::direction: return way_on(ray, difference.next);
    case Answer::visibility: return event_of<RayFinished>(ray);
    default: return 0;
    }
}

} // namespace

bool Walk::stops_at(std::size_t moment) {
    reasons_ = stops_.at(walked(), moment);
    return !reasons_.empty();
}

Moved Walk::go_on() {
    reasons_.clear();
    const Moved moved = cursor_.go_on([this](std::size_t moment) { return stops_at(moment); });
    stops_.count(reasons_);
    return moved;
}

Moved Walk::go_back() {
    reasons_.clear();
    const Moved moved = cursor_.go_back([this](std::size_t moment) { return stops_at(moment); });
    stops_.count(reasons_);
    return moved;
}

void Walk::start_again(Trace trace) {
    trace_ = std::move(trace);
    timeline_ = Timeline(trace_);
    cursor_ = Cursor(trace_, timeline_);
    reasons_.clear();
    divergence_.reset();
}

Spot spot_of(const Trace& first, const Difference& difference) {
    const TracedRay& ray = first.rays[std::size_t(difference.ray)];
    return {difference.ray, event_of(first, ray, difference).value_or(0)};
}

} // namespace rayscope
