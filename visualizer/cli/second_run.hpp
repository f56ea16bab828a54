#pragma once
// Another run of the same ray: other numbers or limits, another stage, another scene.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

struct SecondRun {
    std::string name;
    Trace trace;
    ScalarType scalar = ScalarType::float64;
};

/// "float,textbook", "stage octree", or a scene. Throws UsageError that begins with the command's name.
[[nodiscard]] SecondRun second_run(const std::string& command, const std::string& what,
                                   const Workbench& bench, const Trace& trace);
[[nodiscard]] SecondRun run_by_stage(const std::string& command, const std::string& stage,
                                     const Workbench& bench, const Trace& trace);
[[nodiscard]] SecondRun run_of_scene(const std::string& scene, const Trace& trace);

[[nodiscard]] Comparison compared(const SecondRun& second, const Workbench& bench, const Trace& trace);

/// Both side by side, ray by ray, to where they part; then what parts them.
[[nodiscard]] std::string second_run_text(const SecondRun& second, const Workbench& bench, const Trace& trace,
                                          const StepStyle& style);

} // namespace rayscope::cli
