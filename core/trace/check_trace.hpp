#pragma once
// Whether a Trace that came from outside is one that a tracer could have made: views rely on it.

#include "core/trace/trace_fields.hpp"

namespace rayscope {

/// How many things there are that an id with this target can point at.
[[nodiscard]] std::size_t target_size(const Trace& trace, Target target);

[[nodiscard]] bool allows_none(Target target);

/// Throws std::runtime_error unless the rays form one tree with each child after its parent, each ray begins with
/// its only RaySpawned, and each node stands after its operands and has as many as its operation needs.
void check_trace(const Trace& trace);

} // namespace rayscope
