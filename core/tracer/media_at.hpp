#pragma once
// Which media meet at a boundary, read from the inside lists.

#include "core/world/inside_list.hpp"

namespace rayscope {

/// The media just before and just beyond a hit: object ids, or none for what fills the space between the solids.
struct MediaPair {
    Id from = none, to = none;
};

/// Speed of light in a medium.
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] T speed_in(const World<N>& world, Id medium) {
    return medium == none ? T(world.medium_speed) : T(world.material_of(std::uint32_t(medium)).speed);
}

/// Of all transmitting objects that contain a point, the one with the highest priority is its medium; among equals the
/// last in the file. Offered one after the other.
class Containing {
public:
    void offer(std::int32_t priority, Id object) {
        if (object_ != none && (priority < priority_ || (priority == priority_ && object < object_))) return;
        priority_ = priority;
        object_ = object;
    }
    [[nodiscard]] Id medium() const { return object_; }

private:
    std::int32_t priority_ = 0;
    Id object_ = none;
};

/// The media on both sides of a hit. They depend on the place alone and not on the way there, so a ray may start inside
/// anything and nothing drifts. Boundaries of other media that coincide with the hit are crossed together with it.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] MediaPair media_at(const World<N>& world, const Ray<T>& ray, const Hit<T>& hit,
                                 const Leaving<T>& leaving, Work<T>& work) {
    const Object& own = world.objects[hit.object];
    const bool is_medium = own.has_volume && world.material_of(own).transmits();
    if (world.notes_media) { // the rule of the lecture notes: outside is always air
        if (!is_medium) return {};
        return hit.entering ? MediaPair{none, Id(hit.object)} : MediaPair{Id(hit.object), none};
    }
    Containing before, beyond;
    if (is_medium) (hit.entering ? beyond : before).offer(own.priority, Id(hit.object));
    const Crossing<T> own_crossing{hit.t, hit.surface, hit.entering};
    // Farther from an extent than this no crossing of what is in it can coincide with the hit (see Nearness).
    const Vec3d direction = absolute(as<double>(ray.direction)), origin = absolute(as<double>(ray.origin));
    const double slack = double(Nearness<N>::relative) * (direction.x + direction.y + direction.z);
    const double size =
        magnitude(double(hit.t)) + largest_component(origin) + double(world.solids[hit.surface.solid].reach);
    world.media.each_at(hit.object, as<double>(ray.at(hit.t)), slack, size, [&](std::uint32_t other) {
        bool inside = false, inside_before = false, met = false;
        for (const Crossing<T>& c : crossings(world, other, ray, leaving.of(other), work)) {
            const bool same_place = coincide(world, ray, own_crossing, c);
            if (!same_place && c.t > hit.t) break;
            if (same_place && !met) inside_before = inside;
            met = met || same_place;
            inside = c.entering;
        }
        if (!met) inside_before = inside;
        if (inside_before) before.offer(world.objects[other].priority, Id(other));
        if (inside) beyond.offer(world.objects[other].priority, Id(other));
    });
    return {before.medium(), beyond.medium()};
}

/// The medium at the start of a ray.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Id medium_at_start(const World<N>& world, const Ray<T>& ray, Work<T>& work) {
    Containing here;
    const Vec3d start = as<double>(ray.origin);
    const double slack = double(Nearness<N>::relative), size = largest_component(absolute(start));
    world.media.each_holding(start, slack, size, [&](std::uint32_t object) {
        bool inside = false;
        for (const Crossing<T>& c :
             crossings(world, object, ray, static_cast<const LeavingSurface<T>*>(nullptr), work)) {
            if (c.t > T(0)) break;
            inside = c.entering;
        }
        if (inside) here.offer(world.objects[object].priority, Id(object));
    });
    return here.medium();
}

} // namespace rayscope
