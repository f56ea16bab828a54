#pragma once
// Which cameras see something, and how large their images may be.

#include "core/math/decimals.hpp"
#include "core/scene/scene.hpp"

#include <optional>
#include <string>

namespace rayscope {

inline constexpr int largest_side = 32768; ///< pixels of an image
inline constexpr double most_pixels = 1e8;

/// What is wrong with eye, look_at and up, if anything. The first two are called what the file calls them.
[[nodiscard]] inline std::optional<std::string>
view_problem(const Camera& camera, const std::string& eye = "eye", const std::string& look_at = "look_at") {
    const Vec3d view = camera.look_at - camera.eye;
    if (length(view) == 0) return "'" + eye + "' and '" + look_at + "' are the same point";
    if (length(camera.up) == 0) return "'up' has length zero";
    if (length(cross(normalized(view), normalized(camera.up))) < decimals::least_sine)
        return "'up' is parallel to the view from '" + eye + "' to '" + look_at + "'";
    return std::nullopt;
}

} // namespace rayscope
