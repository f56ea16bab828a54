#pragma once
// The tables of a Trace: the names of what its events point at.

#include "core/scene/scene.hpp"
#include "core/trace/trace.hpp"
#include "core/world/world.hpp"

namespace rayscope {

/// Fills the tables of a trace whose events hold the world's ids, and turns those ids into indices of the tables.
/// What no event names is left out, so that a trace from a scene of a million objects stays small.
void name_trace(Trace& trace, const Scene& scene, const World<double>& world);

} // namespace rayscope
