#pragma once
// Operands of a compound whose flat faces lie in one plane.

#include "core/scene/scene.hpp"

#include <optional>
#include <utility>

namespace rayscope::povray {

/// The first two generics (indices into Scene::generics) with faces in one plane that may meet, if there are any.
/// Compounds of very many operands are not searched.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> flush_operands(const Scene& scene,
                                                                                std::size_t compound);

} // namespace rayscope::povray
