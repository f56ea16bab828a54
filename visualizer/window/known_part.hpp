#pragma once
// A trace as far as a walk has come: what may be shown while a question about the rest is open.

#include "core/rayscope.hpp"

namespace rayscope::window {

/// The rays that have started, with the events up to where the walk stands; of the result nothing.
[[nodiscard]] Trace known_part(const Walk& walk);

/// Whether it is known what became of a ray.
[[nodiscard]] bool is_finished(const TracedRay& ray);

} // namespace rayscope::window
