#pragma once
// What can be caught in the 3D view and moved in the plane that faces the camera.

#include "core/rayscope.hpp"

namespace rayscope::window {

struct Handle {
    enum class Kind : std::uint8_t { light, generic, ray_start, ray_end };
    Kind kind = Kind::light;
    std::size_t index = 0; ///< of the light or of the generic
    std::string name;
    Vec3d at{0};    ///< world
    Vec3d other{0}; ///< of an end of the ray: the end that stays …
    double lever =
        1; ///< … and how many times farther from it the end is, if it is out of sight, than the handle

    /// Where what is moved is when the handle is there.
    [[nodiscard]] Vec3d moved(const Vec3d& to) const {
        return lever == 1 ? to : other + (to - other) * lever;
    }
};

} // namespace rayscope::window
