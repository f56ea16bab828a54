#pragma once
// What a TOML scene says of the added effects.

#include "core/scene/scene.hpp"
#include "core/scene/toml_reader.hpp"

namespace rayscope {

/// Keys of a material beyond the notes' ones.
inline constexpr std::array<std::string_view, 5> optic_keys{"fresnel", "absorption", "abbe", "cauchy",
                                                            "sellmeier"};

/// Reads them into the material, whose other keys have been read.
void read_optics(const TomlTable& table, SceneMaterial& material);

/// A coefficient: a colour, or a pattern of two.
/// @param bounds of each component
void read_coefficient(const TomlValue& value, const Bounds& bounds, Colour& colour,
                      std::optional<Pattern>& pattern);

inline constexpr std::array<std::string_view, 5> area_keys{"sphere", "disk", "facing", "rectangle",
                                                           "samples"};
/// Reads a light's area; a point where it says nothing of one.
void read_area(const TomlTable& table, SceneLight& light);

/// "auto", or the complete list of effects.
[[nodiscard]] std::optional<EffectSet> read_effects(const TomlValue& value);

} // namespace rayscope
