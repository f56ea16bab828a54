#pragma once
// A walk through a trace: the trace, where one is in it, and where going on stops. Every view shows one of these.

#include "core/trace/divergence.hpp"
#include "core/walk/cursor.hpp"
#include "core/walk/stops.hpp"

namespace rayscope {

class Walk {
public:
    explicit Walk(Trace trace) : trace_(std::move(trace)), timeline_(trace_), cursor_(trace_, timeline_) {}
    Walk(const Walk&) = delete; // its parts point at each other
    Walk& operator=(const Walk&) = delete;

    [[nodiscard]] const Trace& trace() const { return trace_; }
    [[nodiscard]] const Timeline& timeline() const { return timeline_; }
    [[nodiscard]] Cursor& cursor() { return cursor_; }
    [[nodiscard]] const Cursor& cursor() const { return cursor_; }
    [[nodiscard]] StopPoints& stops() { return stops_; }
    [[nodiscard]] const StopPoints& stops() const { return stops_; }

    /// On, or back, to where something stops. What did is in `reasons` until the next such move.
    [[nodiscard]] Moved go_on();
    [[nodiscard]] Moved go_back();
    [[nodiscard]] const std::vector<StopReason>& reasons() const { return reasons_; }

    [[nodiscard]] SeenEvent here() const { return walked().seen(cursor_.moment()); }
    [[nodiscard]] WalkedTrace walked() const { return {trace_, timeline_, divergence_}; }

    /// Another trace; breakpoints stay, the way back is forgotten.
    void start_again(Trace trace);
    /// Where another run of the same ray goes another way, if it does.
    void set_divergence(const std::optional<Spot>& spot) { divergence_ = spot; }

private:
    [[nodiscard]] bool stops_at(std::size_t moment);
    Trace trace_;
    Timeline timeline_;
    Cursor cursor_;
    StopPoints stops_;
    std::vector<StopReason> reasons_;
    std::optional<Spot> divergence_;
};

/// The event at which two runs part.
[[nodiscard]] Spot spot_of(const Trace& first, const Difference& difference);

} // namespace rayscope
