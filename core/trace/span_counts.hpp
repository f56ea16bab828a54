#pragma once
// How many spans the nodes of each object have on a ray's line, in two runs.

#include "core/trace/trace.hpp"

#include <optional>
#include <string_view>

namespace rayscope {

struct SpanCountDifference {
    std::string_view object; ///< its name
    Id node = none;
    int first = 0, second = 0;
};

/// Objects are told apart by their names. What one run did not test is no difference where it need not have.
[[nodiscard]] std::optional<SpanCountDifference>
first_span_difference(const Trace& first, const TracedRay& a, const Trace& second, const TracedRay& b);

} // namespace rayscope
