#pragma once
// Two runs of one ray, compared.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

/// As `configuration` reads it, on top of the scene's own. Throws UsageError that begins with the option's name.
[[nodiscard]] Configuration chosen_configuration(const std::string& option, const std::string& list,
                                                 const Configuration& base);

/// The ray of a trace of this workbench once more, with other numbers or limits.
[[nodiscard]] Trace traced_again(const Workbench& bench, const Trace& trace,
                                 const Configuration& configuration);

/// Where the trace, which is the scene's own, and the one with another configuration part, or that they do not.
[[nodiscard]] std::string compare_text(const Workbench& bench, const Trace& trace, const Configuration& other,
                                       const StepStyle& style);

} // namespace rayscope::cli
