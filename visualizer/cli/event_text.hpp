#pragma once
// One event in a sentence or two, with its numbers.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

/// "ray 3, event 5 of 12 · refraction" and what happened; in one line, cut to the page, unless `full`.
[[nodiscard]] std::string event_text(const SeenEvent& seen, const StepStyle& style, bool full);

} // namespace rayscope::cli
