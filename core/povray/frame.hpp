#pragma once
// Where POV-Ray gets the scene: moved and scaled if its fixed distances ask for that.

#include "core/scene/scene.hpp"
#include "core/world/world.hpp"

namespace rayscope::povray {

/// x ↦ scale · (x − origin). Light does not fall off with distance, so no colour changes.
struct Frame {
    double scale = 1;
    Vec3d origin{0};

    [[nodiscard]] Vec3d point(const Vec3d& p) const { return scale * (p - origin); }
    [[nodiscard]] Mat4d matrix(Mat4d m) const;
};

/// The scene's own frame, unless POV-Ray would lose what lies in it: no hit nearer than 0.001 counts there, nor any
/// farther than 10⁷.
[[nodiscard]] Frame frame_of(const Scene& scene, const WorldBase& world);

} // namespace rayscope::povray
