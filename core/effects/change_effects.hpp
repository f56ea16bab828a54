#pragma once
// A scene with an effect taken away or added, for experiments.

#include "core/scene/scene.hpp"

namespace rayscope {

/// Takes what calls for the effect out of the scene: coefficients become 0, areas points, Fresnel's shares those of
/// normal incidence, patterns their mean.
void take_away(Effect effect, Scene& scene);

/// Adds to the scene what calls for the effect, as mild as it shows: 16 samples, lights a twentieth as wide as they are
/// far from what is looked at, an Abbe number of 30, …
/// @return false where the scene has nothing to add it to
[[nodiscard]] bool add_effect(Effect effect, Scene& scene);

/// The scene with these effects and no others.
/// @param needed those that it calls for now
[[nodiscard]] Scene with_effects(Scene scene, const EffectSet& needed, const EffectSet& wanted);

/// What a person writes of effects: "auto"; a complete list, "shadows,refraction"; or changes to those that are
/// needed, "+fresnel,-shadows". Throws std::invalid_argument with what was expected.
[[nodiscard]] EffectSet parse_effects(std::string_view text, const EffectSet& needed);

} // namespace rayscope
