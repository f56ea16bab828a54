#pragma once
// A stage's way through its places, as it is recorded.

#include "core/math/box.hpp"
#include "core/trace/events.hpp"
#include "core/world/counters.hpp"

#include <algorithm>

namespace rayscope {

/// A box in world space, with where the ray is in it.
template <Scalar T>
[[nodiscard]] PlaceEntered place_entered(PlaceKind kind, Id place, int level, int held, const Box<T>& box,
                                         T t_in, T t_out) {
    return {kind,         place,        level, none, held, as<double>(box.low), as<double>(box.high),
            double(t_in), double(t_out)};
}

/// An entry of a list that is read in the order of distance.
[[nodiscard]] inline PlaceEntered entry_read(std::uint32_t object, float nearest) {
    PlaceEntered entry;
    entry.kind = PlaceKind::entry;
    entry.object = Id(object);
    entry.held = 1;
    entry.t_in = double(nearest);
    entry.t_out = infinity<double>;
    return entry;
}

/// @param before, after the number of objects tested so far
[[nodiscard]] inline PlaceLeft place_left(std::uint64_t before, std::uint64_t after, std::size_t held) {
    const int tested = int(after - before);
    return {tested, std::max(0, int(held) - tested)};
}

[[nodiscard]] inline SearchEnded search_ended(SearchEnd reason, double t, const Counters& before,
                                              const Counters& after, std::size_t objects) {
    const int tested = int(after.objects - before.objects);
    return {reason,
            t,
            int(after.cells - before.cells),
            int(after.boxes_missed - before.boxes_missed),
            tested,
            std::max(0, int(objects) - tested)};
}

} // namespace rayscope
