#include "tests/oracle/accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rayscope::test {

void Accuracy::add(const ExactBound& exact, const FoundEnd& found, double epsilon) {
    const double unit = epsilon * exact.tight_condition;
    if (!(unit > 0) || !std::isfinite(unit)) return;
    worst_error_ = std::max(worst_error_, exact.t.distance(found.value()) / unit);
    bounds_.push_back(found.error_bound / unit);
}

double Accuracy::bound_at(double share) const {
    if (bounds_.empty()) return 0;
    std::vector<double> sorted = bounds_;
    const auto at =
        sorted.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return *at;
}

std::string Accuracy::summary() const {
    char text[160];
    std::snprintf(text, sizeof text,
                  "ends %zu, worst error %.3g, bounds: median %.3g, 99 %% below %.3g (of ε · condition)",
                  bounds_.size(), worst_error_, bound_at(0.5), bound_at(0.99));
    return text;
}

} // namespace rayscope::test
