#pragma once
// One object's test, recorded: the inside list of every generic and of every node.

#include "core/trace/recorder.hpp"
#include "core/world/inside_list.hpp"

namespace rayscope {

/// Records what a test of this object on this ray found; nothing if the line misses all of its generics.
/// Evaluates the author's tree, node by node, where the tracer runs the regrouped program: the results agree.
void record_object(const World<double>& world, std::uint32_t object, const Ray<double>& ray,
                   const Range<double>& range, const LeavingSurface<double>* leaving,
                   TraceRecorder& recorder);

} // namespace rayscope
