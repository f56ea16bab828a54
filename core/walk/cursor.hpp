#pragma once
// Where one is in a trace, and the ways to go on: the same for every view.

#include "core/walk/timeline.hpp"

#include <functional>
#include <optional>

namespace rayscope {

/// What became of a move.
enum class Moved : std::uint8_t {
    yes,
    at_start,       ///< nothing happened before
    at_end,         ///< nothing happens after
    no_child,       ///< the ray spawns none from here on
    no_sibling,     ///< the first ray has none, …
    no_parent,      ///< … and nothing spawned it
    nothing_before, ///< no move is left to be undone
};

/// Stands on an event of a ray. A ray's start is its first event; going from ray to ray stops at starts.
class Cursor {
public:
    Cursor(const Trace& trace, const Timeline& timeline) : trace_(&trace), timeline_(&timeline) {}

    [[nodiscard]] Spot spot() const { return timeline_->at(moment_); }
    [[nodiscard]] std::size_t moment() const { return moment_; }
    [[nodiscard]] bool at_ray_start() const { return spot().event == 0; }

    // From event to event, in time.
    [[nodiscard]] Moved step();
    [[nodiscard]] Moved step_back();

    // From ray to ray.
    [[nodiscard]] Moved next();      ///< the start of the next ray, in time
    [[nodiscard]] Moved back();      ///< the latest start of a ray before here
    [[nodiscard]] Moved in();        ///< the next ray that this one spawns
    [[nodiscard]] Moved back_into(); ///< the last event of the ray that this one spawned last

    /// At a ray's start: past it and all that it spawns, to its next sibling, or out. Within a ray: its next event, past
    /// the rays that come between; after the last one out.
    [[nodiscard]] Moved over();
    [[nodiscard]] Moved back_over(); ///< the same backwards
    /// To the parent, where it goes on; backwards: where it was about to spawn this ray.
    [[nodiscard]] Moved out();
    [[nodiscard]] Moved back_out();

    [[nodiscard]] Moved go_to(std::size_t moment);
    [[nodiscard]] Moved go_to(Spot spot) { return go_to(timeline_->moment(spot)); }

    /// Asked for each moment on the way, in the order of the way, the present one left out; true stops there.
    using Stop = std::function<bool(std::size_t moment)>;
    /// On to the first stop, or to the last event (the first one): then `at_end` (`at_start`).
    [[nodiscard]] Moved go_on(const Stop& stop);
    [[nodiscard]] Moved go_back(const Stop& stop);

    /// Where one was before the last move.
    [[nodiscard]] Moved undo();

private:
    [[nodiscard]] const TracedRay& ray() const { return trace_->rays[std::size_t(spot().ray)]; }

    const Trace* trace_;
    const Timeline* timeline_;
    std::size_t moment_ = 0;
    std::vector<std::size_t> before_; // oldest first
};

} // namespace rayscope
