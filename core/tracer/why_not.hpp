#pragma once
// Why a ray did not end on an object: rejections are only counted while tracing, and looked at again when asked for.

#include "core/world/world.hpp"

namespace rayscope {

struct WhyNot {
    enum class Reason : std::uint8_t {
        line_misses,  ///< the ray's whole line has no crossing with it
        behind,       ///< all its crossings lie behind the ray's origin
        beyond_reach, ///< its nearest crossing lies behind the light
        farther,      ///< its nearest crossing lies behind the hit
        accepted,     ///< it was not rejected: the hit is on it, or coincides with one
    };
    Reason reason = Reason::line_misses;
    double t = 0; ///< of its nearest crossing ahead, or, if all lie behind, of the last of those;
                  ///< without meaning if the line misses
};

/// Tests the object again with the kernel that rejected it.
/// @param reach, hit the t at which the ray's light lies and at which it ended; infinity if there is none
/// @param starts_on the ray starts on this object: crossings at its start do not count
[[nodiscard]] WhyNot why_not(const World<double>& world, std::uint32_t object, const Ray<double>& ray,
                             double reach, double hit, bool starts_on);

} // namespace rayscope
