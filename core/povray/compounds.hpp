#pragma once
// A compound as a tree of POV-Ray's operations.

#include "core/povray/frame.hpp"
#include "core/povray/textures.hpp"

namespace rayscope::povray {

/// @param modifiers of the whole, besides its texture: its interior
[[nodiscard]] std::string compound(const Scene& scene, std::size_t index, const Frame& frame,
                                   Textures& textures, const std::string& modifiers);

} // namespace rayscope::povray
