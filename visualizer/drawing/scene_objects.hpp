#pragma once
// Which object of the scene a trace's object is.

#include "core/rayscope.hpp"

namespace rayscope::drawing {

/// For each of trace.objects its index into scene.drawn, which is the world's id too; none if the scene has no
/// object of that name.
[[nodiscard]] std::vector<Id> drawn_objects(const Trace& trace, const Scene& scene);

/// Index into scene.materials of a drawn object; an object without a material counts as the first one.
[[nodiscard]] const SceneMaterial& material_of(const Scene& scene, std::size_t drawn);

} // namespace rayscope::drawing
