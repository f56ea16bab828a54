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

/// One of two runs.
struct Run {
    std::string name;
    const Trace& trace;
    ScalarType scalar;
};
/// Where two runs of the same ray part, or that they do not.
[[nodiscard]] std::string compare_text(const Run& first, const Run& second, const StepStyle& style);

} // namespace rayscope::cli
