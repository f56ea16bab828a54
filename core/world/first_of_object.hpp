#pragma once
// The first crossing of a ray with one object.

#include "core/world/inside_list.hpp"

namespace rayscope {

/// The same as `first_of_object` where the ray starts on the outside of this mesh: not all of the line need be looked at.
/// Not inlined, lest what is the same for all shapes becomes too large to be.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard, gnu::noinline]] std::optional<Hit<T>>
first_from_mesh(const World<N>& world, std::uint32_t object, const Ray<T>& ray, const Range<T>& range,
                const LeavingSurface<T>& leaving, Work<T>& work) {
    const std::uint32_t index = world.objects[object].index;
    const Solid<N>& solid = world.solids[index];
    ++work.counters.objects;
    ++work.counters.tests[solid.shape.index()];
    const auto first = std::get<Mesh<N>>(solid.shape)
                           .closest(solid.transform.to_object(ray), range, leaving.face_of(index),
                                    [&](const MeshCrossing<T>& c) {
                                        return is_start(world, ray, solid.crossing_of(c, index), leaving);
                                    });
    if (!first) return std::nullopt;
    return Hit<T>{first->t, object, solid.crossing_of(*first, index).surface, first->entering, false};
}

/// Whether the ray, which starts on an object and does not lead through its surface, surely never meets it again: a line
/// meets a plane once, and who runs away from a ball's centre has left it, and with it all that lies within; so has who
/// leaves the half space below a plane. It is then counted as tested.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] bool left_for_good(const World<N>& world, const Ray<T>& ray, const LeavingSurface<T>& leaving,
                                 Work<T>& work) {
    const Solid<N>& solid = world.solids[leaving.surface.solid];
    if (leaving.crosses || !solid.holds_object) return false;
    const bool is_all = !world.objects[leaving.object].is_compound;
    bool left = false;
    if (solid.is_ball)
        left =
            !leaving.starts_inside && dot(ray.origin - solid.transform.translation(), ray.direction) >= T(0);
    else if (std::holds_alternative<Plane<N>>(solid.shape))
        left =
            is_all || (!leaving.starts_inside && solid.transform.vector_to_object(ray.direction).z >= T(0));
    else
        left = is_all && std::holds_alternative<Polygon<N>>(solid.shape);
    if (left) {
        ++work.counters.objects;
        ++work.counters.tests[solid.shape.index()];
    }
    return left;
}

/// `first_of_object` where the ray starts on a plain solid that is no mesh: its few crossings need no list.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] std::optional<Crossing<T>> first_from_solid(const World<N>& world, std::uint32_t index,
                                                          const Ray<T>& ray, const Range<T>& range,
                                                          const LeavingSurface<T>& leaving, Work<T>& work) {
    const Solid<N>& solid = world.solids[index];
    ++work.counters.objects;
    ++work.counters.tests[solid.shape.index()];
    std::array<Crossing<T>, 4> ends;
    std::size_t count = 0;
    each_crossing(solid.intervals(ray, leaving.face_of(index)), index,
                  [&](const Crossing<T>& c) { ends[count++] = c; });
    return first_crossing(world, ray, {ends.data(), count}, range, &leaving);
}

/// The same as `first_of_object` for a ball on which the ray does not start. Inlined, so that the hit need not pass through memory.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard, gnu::always_inline]] inline std::optional<Hit<T>>
first_of_ball(const Ball<N>& ball, std::uint32_t object, const Ray<T>& ray, const Range<T>& range,
              Work<T>& work) {
    ++work.counters.objects;
    ++work.counters.tests[generic_index<N, Sphere<N>>()];
    for (const Interval<T>& inside : ball.intervals(ray)) {
        if (range.contains(inside.enter))
            return Hit<T>{inside.enter, object, ball.surface(inside.enter_face), true, false};
        if (range.contains(inside.exit))
            return Hit<T>{inside.exit, object, ball.surface(inside.exit_face), false, false};
    }
    return std::nullopt;
}

/// The first crossing in the range of one object, whatever it is.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] std::optional<Hit<T>> first_of_object(const World<N>& world, std::uint32_t object,
                                                    const Ray<T>& ray, const Range<T>& range,
                                                    const LeavingSurface<T>* leaving, Work<T>& work) {
    const Object& o = world.objects[object];
    const auto hit = [&](const Crossing<T>& c, bool crowded) {
        return Hit<T>{c.t, object, c.surface, c.entering, crowded};
    };
    if (leaving == nullptr && !o.is_compound) {
        ++work.counters.objects;
        ++work.counters.tests[world.solids[o.index].shape.index()];
        const auto first = world.solids[o.index].closest(ray, range, o.index);
        return first ? std::optional(hit(*first, false)) : std::nullopt;
    }
    if (leaving != nullptr && left_for_good(world, ray, *leaving, work)) return std::nullopt;
    const bool is_from_mesh =
        leaving != nullptr && !o.is_compound && std::holds_alternative<Mesh<N>>(world.solids[o.index].shape);
    if (is_from_mesh && !leaving->crosses && !leaving->starts_inside)
        return first_from_mesh(world, object, ray, range, *leaving, work);
    if (!o.is_compound && !is_from_mesh) {
        const auto first = first_from_solid(world, o.index, ray, range, *leaving, work);
        return first ? std::optional(hit(*first, false)) : std::nullopt;
    }
    const auto first =
        first_crossing(world, ray, crossings(world, object, ray, leaving, work), range, leaving);
    if (!first) return std::nullopt;
    return hit(*first, o.is_compound && crowded(world, ray, *first, work));
}

} // namespace rayscope
