#pragma once
// Which media meet at a boundary, read from the inside lists.

#include "core/world/inside_list.hpp"

namespace rayscope {

/// No object: what fills the space between the solids.
inline constexpr std::int64_t outer_medium = -1;

/// The media just before and just beyond a hit: object ids, or outer_medium.
struct MediaPair {
    std::int64_t from = outer_medium, to = outer_medium;
};

/// Speed of light in a medium.
template <Scalar T> [[nodiscard]] T speed_in(const World<T>& world, std::int64_t medium) {
    return medium == outer_medium ? T(world.medium_speed) : T(world.material_of(std::uint32_t(medium)).speed);
}

/// Of all transmitting objects that contain a point, the one with the highest priority is its medium; among equals the
/// last in the file. Offered one after the other.
class Containing {
public:
    void offer(std::int32_t priority, std::uint32_t object) {
        if (object_ != outer_medium && (priority < priority_ || (priority == priority_ && object < object_)))
            return;
        priority_ = priority;
        object_ = object;
    }
    [[nodiscard]] std::int64_t medium() const { return object_; }

private:
    std::int32_t priority_ = 0;
    std::int64_t object_ = outer_medium;
};

/// The media on both sides of a hit. They depend on the place alone and not on the way there, so a ray may start inside
/// anything and nothing drifts. Boundaries of other media that coincide with the hit are crossed together with it:
/// they are added to `coincident`, as seen by a ray that goes on.
template <Scalar T>
[[nodiscard]] MediaPair media_at(const World<T>& world, const Ray<T>& ray, const Hit<T>& hit,
                                 const Leaving<T>& leaving, Leaving<T>& coincident, Work<T>& work) {
    const Object& own = world.objects[hit.object];
    const bool is_medium = own.has_volume && world.material_of(own).transmits();
    if (world.notes_media) { // the rule of the lecture notes: outside is always air
        if (!is_medium) return {};
        return hit.entering ? MediaPair{outer_medium, hit.object} : MediaPair{hit.object, outer_medium};
    }
    Containing before, beyond;
    if (is_medium) (hit.entering ? beyond : before).offer(own.priority, hit.object);
    const T own_bound = error_bound(world, ray, Crossing<T>{hit.t, hit.surface, hit.entering});
    for (const std::uint32_t other : world.media.of(hit.object)) {
        if (other == hit.object) continue;
        bool inside = false, inside_before = false, met = false;
        for (const Crossing<T>& c : crossings(world, other, ray, leaving.of(other), work)) {
            const bool same_place = magnitude(c.t - hit.t) <= own_bound + error_bound(world, ray, c);
            if (!same_place && c.t > hit.t) break;
            if (same_place && !met) {
                met = true;
                inside_before = inside;
                coincident.add({other, c.surface, c.entering});
            }
            inside = c.entering;
        }
        if (!met) inside_before = inside;
        if (inside_before) before.offer(world.objects[other].priority, other);
        if (inside) beyond.offer(world.objects[other].priority, other);
    }
    return {before.medium(), beyond.medium()};
}

/// The medium at the start of a ray.
template <Scalar T>
[[nodiscard]] std::int64_t medium_at_start(const World<T>& world, const Ray<T>& ray, Work<T>& work) {
    Containing here;
    for (const std::uint32_t object : world.media.all()) {
        bool inside = false;
        for (const Crossing<T>& c : crossings(world, object, ray, nullptr, work)) {
            if (c.t > T(0)) break;
            inside = c.entering;
        }
        if (inside) here.offer(world.objects[object].priority, object);
    }
    return here.medium();
}

} // namespace rayscope
