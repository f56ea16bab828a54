#pragma once
// The crossings of one object of the world with one ray.

#include "core/boxes/slab_ray.hpp"
#include "core/csg/clusters.hpp"
#include "core/world/work.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// Not inlined, lest what is the same for all shapes becomes too large to be.
template <Numbers N, Scalar T = ScalarOf<N>>
[[gnu::noinline]] void append_mesh_crossings(const Solid<N>& solid, std::uint32_t index, const Ray<T>& ray,
                                             int leaving, Work<T>& work) {
    std::get<Mesh<N>>(solid.shape).crossings(solid.transform.to_object(ray), leaving, work.of_mesh);
    for (const MeshCrossing<T>& c : work.of_mesh) work.scratch.append(solid.crossing_of(c, index));
}

/// Calls append with each end of a solid's intervals, ascending.
/// A surface without volume is a single crossing: it is met, never inside.
template <Scalar T, typename Append>
void each_crossing(const Intervals<T>& intervals, std::uint32_t solid, const Append& append) {
    for (const Interval<T>& inside : intervals) {
        append(Crossing<T>{inside.enter, {solid, std::int32_t(inside.enter_face), false}, true});
        if (inside.enter < inside.exit)
            append(Crossing<T>{inside.exit, {solid, std::int32_t(inside.exit_face), false}, false});
    }
}

/// Appends a solid's inside list to the open top list.
template <Numbers N, Scalar T = ScalarOf<N>>
void append_crossings(const World<N>& world, std::uint32_t solid, const Ray<T>& ray,
                      const LeavingSurface<T>* leaving, Work<T>& work) {
    const Solid<N>& s = world.solids[solid];
    ++work.counters.tests[s.shape.index()];
    const int start = leaving != nullptr ? leaving->face_of(solid) : no_face;
    if (std::holds_alternative<Mesh<N>>(s.shape)) return append_mesh_crossings(s, solid, ray, start, work);
    each_crossing(s.intervals(ray, start), solid, [&](const Crossing<T>& c) { work.scratch.append(c); });
}

template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] T error_bound(const World<N>& world, const Ray<T>& ray, const Crossing<T>& crossing,
                            T off = T(0)) {
    return world.solids[crossing.surface.solid].error_bound(ray, crossing.t, crossing.surface.face, off);
}

/// How near another crossing must be for it to pay to ask for both error bounds. Where rounding moves the surface of a
/// solid of size r, seen over a distance s, by some ε (r + s), it moves a graze by some √ε (r + s), and nothing by more;
/// this is 256 times as much, room for matrices that distort.
template <Numbers N, Scalar T = ScalarOf<N>> class Nearness {
public:
    static constexpr T relative = limits::power_of_half<T>(limits::digits<T> / 2 - 8);

    Nearness(const World<N>& world, const Ray<T>& ray, const Crossing<T>& crossing)
        : solids_(world.solids),
          t_(crossing.t),
          reach_(magnitude(crossing.t) + largest_component(absolute(ray.origin)) +
                 solids_[crossing.surface.solid].reach) {}

    /// @param solid the one that is crossed at t
    [[nodiscard]] bool holds(T t, std::uint32_t solid) const {
        return magnitude(t - t_) <= relative * (reach_ + solids_[solid].reach);
    }

private:
    const std::vector<Solid<N>>& solids_;
    T t_, reach_;
};

/// Whether rounding may be all that parts two crossings: they lie within the sum of their error bounds.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] bool coincide(const World<N>& world, const Ray<T>& ray, const Crossing<T>& a,
                            const Crossing<T>& b) {
    return Nearness<N>(world, ray, a).holds(b.t, b.surface.solid) &&
           magnitude(b.t - a.t) <= error_bound(world, ray, a) + error_bound(world, ray, b);
}

/// Ignores what merge_clusters reports.
inline constexpr auto unrecorded = [](const auto&) {};

/// Merges coincident crossings of the list on top of the scratch, which is a compound's result. The schoolbook, which
/// has no bounds to tell coincidence by, leaves them.
template <Numbers N, Scalar T = ScalarOf<N>, typename Merged>
void settle(const World<N>& world, const Ray<T>& ray, SpanStack<T>& scratch, const Merged& merged) {
    if (is_textbook<N> || scratch.top_size() < 2) return;
    const std::span list(scratch.top_begin(), scratch.top_size());
    scratch.resize_top(merge_clusters(
        list, [&](const auto& a, const auto& b) { return coincide(world, ray, a, b); }, merged));
}

/// Which parts of a compound a ray's whole line misses: counted, and only asked where the stage wants it.
template <Scalar T> class MissedParts {
public:
    /// @param leaving the ray's start on this compound, or nullptr: there it is in a part's box, if only by rounding
    MissedParts(const Compound& compound, const Ray<T>& ray, const LeavingSurface<T>* leaving, Work<T>& work)
        : compound_(compound), ray_(ray), leaving_(leaving), work_(work) {}

    [[nodiscard]] bool operator()(std::uint32_t extent) { return work_.tests_parts && misses(extent); }

private:
    [[gnu::noinline]] bool misses(std::uint32_t extent) {
        if (!slabs_)
            slabs_.emplace(ray_, T(compound_.size), most_distorted<T>,
                           leaving_ != nullptr ? leaving_->beside : T(0));
        ++work_.counters.boxes;
        if (!slabs_->reliable() || slabs_->line_may_pass(as<T>(compound_.extents[extent].box))) return false;
        ++work_.counters.boxes_missed;
        return true;
    }

    const Compound& compound_;
    const Ray<T>& ray_;
    const LeavingSurface<T>* leaving_;
    Work<T>& work_;
    std::optional<SlabRay<T>> slabs_;
};

/// Notes the crossings of the list on top of the scratch, which is an operand's.
template <Scalar T> void note_ends(Work<T>& work) {
    const Crossing<T>* const first = work.scratch.top_begin();
    for (std::size_t i = 0; i < work.scratch.top_size(); ++i)
        work.of_operands.push_back({first[i].t, first[i].surface.solid});
}

/// The inside list of a compound that has a truth table, appended to the open top list.
/// @return false where the table can't tell: nothing is appended then
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] bool append_by_table(const World<N>& world, const Compound& compound, const Ray<T>& ray,
                                   const LeavingSurface<T>* leaving, Work<T>& work) {
    OperandEnds<T> ends;
    const auto interval = [&](std::uint32_t index) {
        const Solid<N>& solid = world.solids[index];
        ++work.counters.tests[solid.shape.index()];
        const auto inside = solid.intervals(ray, leaving != nullptr ? leaving->face_of(index) : no_face);
        return inside.count > 0 ? inside.items[0] : Interval<T>::nothing();
    };
    MissedParts<T> misses(compound, ray, leaving, work);
    const bool may_hold = gather_ends(std::span<const Instruction>(compound.program),
                                      std::span<const PartExtent>(compound.extents), interval, misses, ends);
    if (ends.tied()) return false;
    if (!may_hold) return true;
    ends.sweep(compound.table, work.scratch);
    if constexpr (!is_textbook<N>)
        for (const auto& end : ends) work.of_operands.push_back({end.t, end.solid});
    return true;
}

/// The object's crossings with the ray's whole line, ascending; valid until the scratch is used again.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] std::span<const Crossing<T>> crossings(const World<N>& world, std::uint32_t object,
                                                     const Ray<T>& ray, const LeavingSurface<T>* leaving,
                                                     Work<T>& work) {
    const Object& o = world.objects[object];
    ++work.counters.objects;
    if (o.is_compound) {
        ++work.counters.compounds;
        work.of_operands.clear();
        const Compound& compound = world.compounds[o.index];
        work.scratch.clear();
        work.scratch.push();
        if (compound.table.count == 0 || !append_by_table(world, compound, ray, leaving, work)) {
            MissedParts<T> misses(compound, ray, leaving, work);
            run(
                std::span<const Instruction>(compound.program), work.scratch,
                [&](std::uint32_t solid) {
                    append_crossings(world, solid, ray, leaving, work);
                    if constexpr (!is_textbook<N>) note_ends(work);
                },
                std::span<const PartExtent>(compound.extents), misses);
        }
        settle(world, ray, work.scratch, unrecorded);
    } else {
        work.scratch.clear();
        work.scratch.push();
        append_crossings(world, o.index, ray, leaving, work);
    }
    return {work.scratch.top_begin(), work.scratch.top_size()};
}

/// The surface that a crowded hit belongs to. Where faces of several operands coincide, rounding decides which of them the
/// crossing at t came from, and neighbouring pixels would name now one operand, now the other. So the crossings that
/// can't be told from the hit are put at its t, where the sweep's rule holds: the left operand has the face.
/// The schoolbook takes what rounding chose.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Surface owner(const World<N>& world, const Ray<T>& ray, const Hit<T>& hit,
                            const LeavingSurface<T>* leaving, Work<T>& work) {
    const Object& o = world.objects[hit.object];
    const Crossing<T> own{hit.t, hit.surface, hit.entering};
    run(std::span<const Instruction>(world.compounds[o.index].program), work.scratch,
        [&](std::uint32_t solid) {
            append_crossings(world, solid, ray, leaving, work);
            for (std::size_t i = 0; i < work.scratch.top_size(); ++i) {
                Crossing<T>& crossing = work.scratch.top_begin()[i];
                if (coincide(world, ray, own, crossing)) crossing.t = hit.t;
            }
        });
    const std::span list(work.scratch.top_begin(), work.scratch.top_size());
    for (const Crossing<T>& crossing : list)
        if (crossing.t == hit.t && crossing.entering == hit.entering) return crossing.surface;
    return hit.surface;
}

/// Where the ray starts on this object: is this crossing its start once more? The surface itself is put at t = 0 by its
/// kernel; here are the same surface under another name (a coincident face of another operand) and a graze, which may
/// lie on either side of the start by as much as both are uncertain. They betray themselves by leading to the side on
/// which the ray already runs.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] bool is_start(const World<N>& world, const Ray<T>& ray, const Crossing<T>& crossing,
                            const LeavingSurface<T>& leaving) {
    if (world.objects[leaving.object].has_volume && crossing.entering != leaving.starts_inside) return false;
    return magnitude(crossing.t) <= T(2) * error_bound(world, ray, crossing, leaving.bound) ||
           (!is_textbook<N> &&
            world.solids[crossing.surface.solid].hugs(ray, crossing.t, crossing.surface.face, leaving.bound));
}

/// The first crossing in the range. Where the ray starts on this object, its start does not count, or, if it leads
/// through that surface, counts as t = 0.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] std::optional<Crossing<T>>
first_crossing(const World<N>& world, const Ray<T>& ray, std::span<const Crossing<T>> list,
               const Range<T>& range, const LeavingSurface<T>* leaving) {
    for (Crossing<T> crossing : list) {
        if (leaving != nullptr && leaving->crosses && crossing.entering != leaving->starts_inside &&
            crossing.t <= range.min &&
            -crossing.t <= T(2) * error_bound(world, ray, crossing, leaving->bound)) {
            crossing.t = range.min;
            return crossing;
        }
        if (!range.contains(crossing.t)) continue;
        if (leaving != nullptr && is_start(world, ray, crossing, *leaving)) continue;
        return crossing;
    }
    return std::nullopt;
}

/// Whether another operand of the compound that was just asked for its crossings has one near this.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] bool crowded(const World<N>& world, const Ray<T>& ray, const Crossing<T>& crossing,
                           const Work<T>& work) {
    if (is_textbook<N>) return false;
    const Nearness<N> near(world, ray, crossing);
    return std::any_of(work.of_operands.begin(), work.of_operands.end(), [&](const OperandEnd<T>& other) {
        return other.solid != crossing.surface.solid && near.holds(other.t, other.solid);
    });
}

} // namespace rayscope
