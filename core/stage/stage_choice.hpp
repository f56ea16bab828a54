#pragma once
// Which stage finds the hits of which rays.

#include "core/stage/octree_limits.hpp"
#include "core/trace/events.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace rayscope {

/// One for each kind of ray.
struct StageChoice {
    StageKind eye = StageKind::scan, shadow = StageKind::scan, other = StageKind::scan;
    OctreeLimits octree = {}; ///< where one is built

    friend bool operator==(const StageChoice&, const StageChoice&) = default;
};

/// The rungs of the ladder by their names. Projective extents serve eye rays and the lights' extents shadow rays alone:
/// on their rungs the other rays stay on the rung below.
struct Rung {
    std::string_view name;
    StageChoice choice;
};
inline constexpr std::array<Rung, 6> rungs{{
    {"scan", {StageKind::scan, StageKind::scan, StageKind::scan}},
    {"extents", {StageKind::extents, StageKind::extents, StageKind::extents}},
    {"projective", {StageKind::projective, StageKind::extents, StageKind::extents}},
    {"light", {StageKind::projective, StageKind::light, StageKind::extents}},
    {"octree", {StageKind::octree, StageKind::octree, StageKind::octree}},
    {"bvh", {StageKind::bvh, StageKind::bvh, StageKind::bvh}},
}};

[[nodiscard]] std::string_view name_of(StageKind kind);

/// A rung's name, or "eye=projective,shadow=light,other=bvh" (what is not named is as on the rung bvh). Behind either the
/// limits of an octree: "octree,capacity=1,least_size=0.01" is the lecture notes' rule.
/// Throws std::invalid_argument that says which word is wrong and what was expected.
[[nodiscard]] StageChoice stage_choice(std::string_view text);

/// "projective for eye rays, light for shadow rays, bvh for all others"; "octree" where one serves all.
[[nodiscard]] std::string described(const StageChoice& choice);

} // namespace rayscope
