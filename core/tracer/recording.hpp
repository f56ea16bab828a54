#pragma once
// The events that need more than their arguments.

#include "core/trace/recorder.hpp"
#include "core/tracer/budget.hpp"
#include "core/tracer/interaction.hpp"

namespace rayscope {

template <Scalar T>
[[nodiscard]] RaySpawned spawned(RayKind kind, const Ray<T>& ray, const Leaving<T>& leaving,
                                 const Budget& budget, T reach = infinity<T>, Id light = none) {
    RaySpawned event{kind,          budget.depth, budget.weight,     ray.origin,
                     ray.direction, reach,        Id(budget.medium), light};
    if (leaving.count > 0) {
        event.left_object = Id(leaving.items[0].object);
        event.left_bound = leaving.items[0].bound;
    }
    return event;
}

template <Scalar T> [[nodiscard]] BoundaryChosen boundary_chosen(const Interaction<T>& at) {
    const Surface& surface = at.hit.surface;
    return {Id(at.hit.object), {at.hit.t, Id(surface.solid), int(surface.face), surface.flipped},
            at.hit.entering,   at.error_bound,
            at.point,          at.normal,
            at.facing,         Id(at.media.from),
            Id(at.media.to),   at.speed_from,
            at.speed_to};
}

} // namespace rayscope
