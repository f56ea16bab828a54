#pragma once
// What the scene gives to a ray at its end: colours and coefficients, which no calculation has touched.

#include "core/trace/trace.hpp"

#include <string_view>

namespace rayscope {

struct GivenDifference {
    std::string_view what;
    Id light = none; ///< whose it is
    Vec3d first{0}, second{0};
};

/// Whether the coefficients of the rays that go on were calculated in both runs.
[[nodiscard]] bool has_calculated_shares(const TracedRay& a, const TracedRay& b);

/// Between two runs of a ray that end alike.
[[nodiscard]] std::optional<GivenDifference> first_given_difference(const TracedRay& a, const TracedRay& b);

} // namespace rayscope
