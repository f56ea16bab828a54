#pragma once
// Where a scene means something else to POV-Ray than to us.

#include "core/scene/scene.hpp"
#include "core/world/world.hpp"

#include <string>
#include <vector>

namespace rayscope::povray {

/// One sentence for each thing in the scene that POV-Ray can't do, or does in another way.
[[nodiscard]] std::vector<std::string> differences(const Scene& scene, const WorldBase& world);

/// Whether any light has shadows.
[[nodiscard]] bool casts_shadows(const Scene& scene);

/// POV-Ray's largest max_trace_level, which counts the eye ray.
inline constexpr int most_trace_levels = 256;

} // namespace rayscope::povray
