#include "core/walk/stops.hpp"

#include <algorithm>

namespace rayscope {

int StopPoints::add(Expression expression, bool watches, bool once) {
    points_.push_back({++last_, std::move(expression), watches, once});
    return last_;
}

int StopPoints::add_breakpoint(Expression condition, bool once) {
    if (condition.type() != ValueType::condition)
        throw WrongExpression(1,
                              "expected a condition: compare the value with something, as in 'depth >= 3'");
    return add(std::move(condition), false, once);
}

int StopPoints::add_watch(Expression expression) { return add(std::move(expression), true, false); }

bool StopPoints::remove(int number) {
    return std::erase_if(points_, [&](const StopPoint& point) { return point.number == number; }) > 0;
}

bool StopPoints::enable(int number, bool on) {
    const auto found = std::ranges::find(points_, number, &StopPoint::number);
    if (found == points_.end()) return false;
    found->enabled = on;
    return true;
}

std::vector<StopReason> StopPoints::at(const WalkedTrace& walked, std::size_t moment) const {
    std::vector<StopReason> reasons;
    const SeenEvent seen = walked.seen(moment);
    for (const StopPoint& point : points_) {
        if (!point.enabled) continue;
        StopReason reason{point.number, point.watches, point.expression.text(), {}, {}};
        if (point.watches) {
            reason.now = point.expression.value(seen);
            if (std::holds_alternative<std::monostate>(reason.now)) continue;
            if (moment > 0) reason.before = latest_value(point.expression, walked, moment - 1);
            if (reason.now == reason.before) continue;
        } else if (!point.expression.holds(seen)) {
            continue;
        }
        reasons.push_back(std::move(reason));
    }
    return reasons;
}

void StopPoints::count(const std::vector<StopReason>& reasons) {
    for (const StopReason& reason : reasons)
        if (const auto found = std::ranges::find(points_, reason.number, &StopPoint::number);
            found != points_.end())
            ++found->hits;
    std::erase_if(points_, [](const StopPoint& point) { return point.once && point.hits > 0; });
}

Value latest_value(const Expression& expression, const WalkedTrace& walked, std::size_t moment) {
    for (std::size_t m = moment + 1; m-- > 0;) {
        Value value = expression.value(walked.seen(m));
        if (!std::holds_alternative<std::monostate>(value)) return value;
    }
    return {};
}

} // namespace rayscope
