#pragma once
// The case that an event is, of the exercise whose function answers the same question.

#include "core/rayscope.hpp"

#include <optional>
#include <string>

namespace rayscope::exercises {

struct EventPlace {
    const Trace& trace;
    const TracedRay& ray;
    std::size_t index = 0; ///< in the ray's events
};

/// "3-01-mirror", and the arguments of its function as C++.
struct EventCase {
    std::string exercise, arguments;
};

// Nothing for an event of another kind, or one that lacks what the function is asked with.

/// What happens at a boundary: mirrored and refracted directions, Fresnel's shares, the wall and its media.
[[nodiscard]] std::optional<EventCase> surface_case(const EventPlace& place);
/// Where the ray is inside: a generic's hits, a compound's tree.
[[nodiscard]] std::optional<EventCase> inside_case(const EventPlace& place);
/// Where the ray looks for hits: boxes, cells, the nearest of all hits.
[[nodiscard]] std::optional<EventCase> search_case(const EventPlace& place);
/// How rays follow each other: where they start, what they bring back, where they end.
[[nodiscard]] std::optional<EventCase> path_case(const EventPlace& place);

} // namespace rayscope::exercises
