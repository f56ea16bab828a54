#pragma once
// Where going on stops: breakpoints, and values that are watched.

#include "core/walk/expression.hpp"
#include "core/walk/timeline.hpp"

namespace rayscope {

/// What a stop looks at: a trace, and where in it another run goes another way.
struct WalkedTrace {
    const Trace& trace;
    const Timeline& timeline;
    std::optional<Spot> divergence;

    [[nodiscard]] SeenEvent seen(std::size_t moment) const {
        const Spot spot = timeline.at(moment);
        return {trace, spot.ray, spot.event, divergence == spot};
    }
};

struct StopPoint {
    int number = 0;
    Expression expression;
    bool watches = false; ///< stops where the value becomes another; else where the condition holds
    bool once = false;    ///< goes away when it has stopped
    bool enabled = true;
    int hits = 0;
};

/// Why it stopped.
struct StopReason {
    int number = 0;
    bool watches = false;
    std::string expression;
    Value before, now; ///< of what is watched
};

class StopPoints {
public:
    /// Throws WrongExpression where a breakpoint's expression is no condition.
    int add_breakpoint(Expression condition, bool once = false);
    int add_watch(Expression expression);

    /// False if there is no such number.
    [[nodiscard]] bool remove(int number);
    [[nodiscard]] bool enable(int number, bool on);
    void clear() { points_.clear(); }
    [[nodiscard]] const std::vector<StopPoint>& all() const { return points_; }

    /// What stops at a moment; nothing is counted yet.
    [[nodiscard]] std::vector<StopReason> at(const WalkedTrace& walked, std::size_t moment) const;
    /// Counts, and drops what stops once.
    void count(const std::vector<StopReason>& reasons);

private:
    int add(Expression expression, bool watches, bool once);
    std::vector<StopPoint> points_;
    int last_ = 0;
};

/// The latest value at or before a moment that the events had.
[[nodiscard]] Value latest_value(const Expression& expression, const WalkedTrace& walked, std::size_t moment);

} // namespace rayscope
