#pragma once
// Which effects a scene calls for, and why.

#include "core/scene/scene.hpp"
#include "core/world/world.hpp"

namespace rayscope {

struct EffectNeed {
    Effect effect = Effect::ambient;
    bool needed = false;
    std::string reason; ///< a sentence with the names of a material, a light or objects, and where they stand
};

/// One for each effect, in their order, found from what the scene's own lights, materials and objects say. What no
/// drawn object has does not count.
/// @param world the scene's
[[nodiscard]] std::vector<EffectNeed> effect_needs(const Scene& scene, const WorldBase& world);

[[nodiscard]] EffectSet needed_effects(const std::vector<EffectNeed>& needs);

} // namespace rayscope
