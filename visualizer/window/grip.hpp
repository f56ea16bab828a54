#pragma once
// A generic that can be moved: drawn by itself, or as an operand at one of its places.

#include "core/rayscope.hpp"

#include <functional>

namespace rayscope::window {

struct Grip {
    std::size_t generic = 0; ///< index into Scene::generics
    Mat4d outer{1};          ///< of the space that it stands in → world

    friend bool operator==(const Grip&, const Grip&) = default;
};

/// In world space; of a half space a point of its boundary.
[[nodiscard]] Vec3d middle_of(const Scene& scene, const Grip& grip);

/// By how much its matrix must move for the middle to be there.
[[nodiscard]] Vec3d offset_to(const Scene& scene, const Grip& grip, const Vec3d& middle);

/// A drawn object's generics, operands from left to right; none where there are too many to choose from.
[[nodiscard]] std::vector<Grip> grips_of(const Scene& scene, std::size_t drawn);

/// The generic whose surface a ray meets first.
/// @param seen whether the surface of a drawn object is one that is looked at, from its outside or not
[[nodiscard]] std::optional<Grip> grip_at(const Workbench& bench, Ray<double> ray,
                                          const std::function<bool(std::size_t drawn, bool entering)>& seen);

} // namespace rayscope::window
