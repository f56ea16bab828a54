#pragma once
// Inside intervals as bars of a terminal.

#include "visualizer/cli/step_text.hpp"

#include <optional>

namespace rayscope::cli {

/// A lane for each object, and for each part of a compound, that the line of a ray meets, over one axis of t; the ray's
/// end is marked.
/// @param sweep a t: each lane then says whether it is inside there
[[nodiscard]] std::string bars_text(const Trace& trace, int ray, std::optional<double> sweep,
                                    const StepStyle& style);

} // namespace rayscope::cli
