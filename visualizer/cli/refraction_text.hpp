#pragma once
// The refraction card of a terminal.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

/// Drawn angles, and all numbers of the boundary; a sentence where the ray meets none that lets light through.
[[nodiscard]] std::string refraction_text(const Trace& trace, int ray, const StepStyle& style);

} // namespace rayscope::cli
