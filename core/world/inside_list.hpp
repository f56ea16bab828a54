#pragma once
// The crossings of one object of the world with one ray.

#include "core/csg/clusters.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// The surface on which a secondary ray starts, and on which side of its object it runs.
struct LeavingSurface {
    std::uint32_t object = 0;
    Surface surface;
    bool starts_inside = false;

    /// The face, if it is one of this solid's.
    [[nodiscard]] int face_of(std::uint32_t solid) const { return surface.solid == solid ? surface.face : no_face; }
};

/// Working memory for one thread.
template <Scalar T> using Scratch = SpanStack<T>;

/// Appends a solid's inside list to the open top list.
/// A surface without volume is a single crossing: it is met, never inside.
template <Scalar T>
void append_crossings(const World<T>& world, std::uint32_t solid, const Ray<T>& ray, const LeavingSurface* leaving,
                      Scratch<T>& scratch) {
    const Solid<T>& s = world.solids[solid];
    for (const Interval<T>& inside : s.intervals(ray, leaving != nullptr ? leaving->face_of(solid) : no_face)) {
        scratch.append({inside.enter, {solid, std::uint16_t(inside.enter_face), false}, true});
        if (inside.enter < inside.exit)
            scratch.append({inside.exit, {solid, std::uint16_t(inside.exit_face), false}, false});
    }
}

template <Scalar T>
[[nodiscard]] T error_bound(const World<T>& world, const Ray<T>& ray, const Crossing<T>& crossing) {
    return world.solids[crossing.surface.solid].error_bound(ray, crossing.t, crossing.surface.face);
}

/// Ignores what merge_clusters reports.
inline constexpr auto unrecorded = [](const auto&) {};

/// Merges coincident crossings of the list on top of the scratch, which is a compound's result.
template <Scalar T, typename Merged>
void settle(const World<T>& world, const Ray<T>& ray, Scratch<T>& scratch, const Merged& merged) {
    if (scratch.top_size() < 2) return;
    const std::span list(scratch.top_begin(), scratch.top_size());
    scratch.resize_top(
        merge_clusters(list, [&](const Crossing<T>& c) { return error_bound(world, ray, c); }, merged));
}

/// The object's crossings with the ray's whole line, ascending; valid until the scratch is used again.
template <Scalar T>
[[nodiscard]] std::span<const Crossing<T>> crossings(const World<T>& world, std::uint32_t object,
                                                     const Ray<T>& ray, const LeavingSurface* leaving,
                                                     Scratch<T>& scratch) {
    const Object& o = world.objects[object];
    if (o.is_compound) {
        run(std::span<const Instruction>(world.compounds[o.index].program), scratch,
            [&](std::uint32_t solid) { append_crossings(world, solid, ray, leaving, scratch); });
        settle(world, ray, scratch, unrecorded);
    } else {
        scratch.clear();
        scratch.push();
        append_crossings(world, o.index, ray, leaving, scratch);
    }
    return {scratch.top_begin(), scratch.top_size()};
}

/// The first crossing in the range, or nullptr. Where the ray starts on this object, a crossing at its very start that
/// would lead to the side on which it already runs is that surface once more, under another name (a coincident face,
/// a graze): it does not count.
template <Scalar T>
[[nodiscard]] const Crossing<T>* first_crossing(const World<T>& world, const Ray<T>& ray,
                                                std::span<const Crossing<T>> list, const Range<T>& range,
                                                const LeavingSurface* leaving) {
    for (const Crossing<T>& crossing : list) {
        if (!range.contains(crossing.t)) continue;
        if (leaving != nullptr && world.objects[leaving->object].has_volume &&
            crossing.entering == leaving->starts_inside &&
            crossing.t <= T(2) * error_bound(world, ray, crossing)) {
            continue;
        }
        return &crossing;
    }
    return nullptr;
}

} // namespace rayscope
