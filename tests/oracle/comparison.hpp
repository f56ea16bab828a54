#pragma once
// What the core found against what is exact. Every function returns the first fault in words, or nothing.

#include "core/cases/exact_cases.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rayscope::test {

/// The oracle states tolerances for inputs that are off by 64 ε; the core is to keep within 4.
inline double allowed_of(double tolerance) { return tolerance * 4 / 64; }

/// One end of a span, as the core found it.
struct FoundEnd {
    double t = 0;
    double error_bound = 0;
    std::size_t leaf = 0;
    std::string face; ///< in the oracle's words
    bool flipped = false;
    Vec3d normal{0};
    double t_rest = 0; ///< what t lacks, where the numbers are wider than double

    [[nodiscard]] Float128 value() const { return Float128(t) + Float128(t_rest); }
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

/// As many spans as `spans`, and every end within `allowed_share` of its tight tolerance, or (loose)
/// within its plain one.
[[nodiscard]] Fault fault_in_spans(const LineCase& exact, const std::vector<ExactSpan>& spans,
                                   const FoundSpans& found, bool loose = false);

/// A stretch of t.
struct Piece {
    long double from, to;
};
/// Where exact and found spans differ.
[[nodiscard]] std::vector<Piece> symmetric_difference(const LineCase& exact, const FoundSpans& found);

/// The length of that against the sum of all tolerances. A near miss has no exact hit and so no tolerance:
/// pieces whose middle lies on a surface, up to the error that decidability is about, do not count.
[[nodiscard]] Fault fault_in_measure(const LineCase& exact, const FoundSpans& found);

/// All of the above, as the case's flags ask for it.
[[nodiscard]] Fault fault_in_case(const LineCase& exact, const FoundSpans& found);

/// Leaf, face, side and normal are those of a surface that meets there; or of the same leaf's neighbouring
/// face, where rounding can move the point across their edge.
[[nodiscard]] Fault fault_in_end(const LineCase& exact, const ExactBound& bound, const FoundEnd& found);

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
