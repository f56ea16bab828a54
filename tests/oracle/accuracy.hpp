#pragma once
// How exact a core is: its errors and its error bounds, both in units of what the problem itself makes of ε.

#include "tests/oracle/comparison.hpp"

#include <vector>

namespace rayscope::test {

class Accuracy {
public:
    /// Ends whose condition is 0 or infinite have no unit and are left out.
    void add(const ExactBound& exact, const FoundEnd& found, double epsilon);

    [[nodiscard]] bool empty() const { return bounds_.empty(); }
    /// |t − exact| / (ε · condition)
    [[nodiscard]] double worst_error() const { return worst_error_; }
    /// error_bound / (ε · condition), by share of all ends: 0.5 is the median.
    [[nodiscard]] double bound_at(double share) const;
    /// "ends 120, worst error 0.81, bounds: median 4.1, 99 % below 9.7 (of ε · condition)"
    [[nodiscard]] std::string summary() const;

private:
    double worst_error_ = 0;
    std::vector<double> bounds_;
};

} // namespace rayscope::test
