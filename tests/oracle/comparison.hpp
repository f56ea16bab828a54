#pragma once
// What the core found against what is exact. Every function returns the first fault in words, or nothing.

#include "tests/oracle/cases.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rayscope::test {

/// One end of a span, as the core found it.
struct FoundEnd {
    double t = 0;
    double error_bound = 0;
    std::size_t leaf = 0;
    std::string face; ///< in the oracle's words
    bool flipped = false;
    Vec3d normal{0};
};

struct FoundSpan {
    FoundEnd enter, exit;
};

using FoundSpans = std::vector<FoundSpan>;
using Fault = std::optional<std::string>;

/// Tolerances are stated for inputs that are off by 64 ε; a core that is worth its name stays within 4 ε.
inline constexpr double allowed_share = 4.0 / 64.0;

/// No NaN, and ascending: enter < exit ≤ next enter.
[[nodiscard]] Fault fault_in_order(const FoundSpans& found);

/// As many spans as `exact`, and every end within `share` of its tolerance: the tight one, or (loose) the plain one.
[[nodiscard]] Fault fault_in_spans(const LineCase& exact, const std::vector<ExactSpan>& spans,
                                   const FoundSpans& found, bool loose = false);

/// The length on which exact and found spans differ; infinite where they differ far out.
[[nodiscard]] double symmetric_difference(const LineCase& exact, const FoundSpans& found);

/// That length against the sum of all tolerances. A near miss has no exact hit and so no tolerance: the found ends'
/// own error bounds stand in.
[[nodiscard]] Fault fault_in_measure(const LineCase& exact, const FoundSpans& found);

/// All of the above, as the case's flags ask for it.
[[nodiscard]] Fault fault_in_case(const LineCase& exact, const FoundSpans& found);

/// The normal is one of those of the surfaces that meet there; leaf, face and side are too, if `surfaces` is set.
[[nodiscard]] Fault fault_in_end(const ExactBound& exact, const FoundEnd& found, bool surfaces);

/// The exact bounds with their found ends, in order; empty where their numbers differ.
struct MatchedEnd {
    const ExactBound* exact;
    const FoundEnd* found;
};
[[nodiscard]] std::vector<MatchedEnd> matched_ends(const LineCase& exact, const std::vector<ExactSpan>& spans,
                                                   const FoundSpans& found);

/// The case in hex floats with what was expected and what was found, to be copied.
[[nodiscard]] std::string describe(const LineCase& exact, const FoundSpans& found);

} // namespace rayscope::test
