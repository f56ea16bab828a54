#pragma once
// The tables of a Trace: the names of what its events point at.

#include "core/scene/scene.hpp"
#include "core/trace/trace.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// The name of a generic; where the file gives none, its kind and its place in the list: "sphere #12".
[[nodiscard]] std::string generic_title(const Scene& scene, std::size_t generic);

/// The name by which a drawn object stands in a Trace.
[[nodiscard]] std::string object_title(const Scene& scene, const SceneObject& drawn);

/// Fills the tables of a trace whose events hold the world's ids, and turns those ids into indices of the tables.
/// What no event names is left out, so that a trace from a scene of a million objects stays small.
void name_trace(Trace& trace, const Scene& scene, const World<double>& world);

} // namespace rayscope
