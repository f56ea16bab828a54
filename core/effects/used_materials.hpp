#pragma once
// Which materials of a scene a ray can meet.

#include "core/scene/scene.hpp"

namespace rayscope {

/// A material and the first drawn object that has it.
struct UsedMaterial {
    std::size_t material; ///< index into Scene::materials
    std::size_t object;   ///< index into Scene::drawn
    bool is_object;       ///< it is the object's; else only that of a wall which an operand contributes
};

/// Each once, in the order of the scene's list. A material that is no object's own is no medium and mirrors nothing.
[[nodiscard]] std::vector<UsedMaterial> used_materials(const Scene& scene);

} // namespace rayscope
