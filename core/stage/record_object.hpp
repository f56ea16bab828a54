#pragma once
// One object's test, recorded: the inside list of every generic and of every node.

#include "core/trace/recorder.hpp"
#include "core/world/inside_list.hpp"

namespace rayscope {

/// Records what a test of this object on this ray found; nothing if the line misses all of its generics.
/// Evaluates the author's tree, node by node, where the tracer runs the regrouped program: the results agree.
/// @param tests_parts the stage has the boxes of a compound's parts tested: those that the line may pass come first
template <Numbers N, Scalar T = ScalarOf<N>>
void record_object(const World<N>& world, std::uint32_t object, const Ray<T>& ray, const Range<T>& range,
                   const LeavingSurface<T>* leaving, bool tests_parts, TraceRecorder& recorder);

} // namespace rayscope
