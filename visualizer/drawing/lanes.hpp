#pragma once
// Where a ray is inside: one lane for each generic and each node of a compound, for the timeline and for the view.

#include "visualizer/drawing/palette.hpp"

#include <string>

namespace rayscope::drawing {

struct Lane {
    Id object = none, node = none;
    std::string label;
    Rgb colour;
    bool root = false; ///< the object itself
    std::vector<SpanFound> spans;
};

/// What a ray's line meets only so many times farther than its hit is not shown.
inline constexpr double far_behind = 3.5;

struct Lanes {
    std::vector<Lane> shown;
    std::size_t hidden = 0;
};

/// The object that was hit comes first, then the others that the ray's line meets, in their order; within an object
/// the leaves and nodes come before the root, as they are evaluated.
/// @param most the largest number shown
[[nodiscard]] Lanes lanes_of(const Trace& trace, const TracedRay& ray, std::size_t most);

/// Text of a node with its operation, "(outer − inner) − mouth".
[[nodiscard]] std::string lane_label(const Trace& trace, Id object, Id node);

} // namespace rayscope::drawing
