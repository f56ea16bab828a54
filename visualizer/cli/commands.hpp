#pragma once
// The commands of the program: each returns its exit code, and throws InputError, UsageError or another
// std::exception where it can't go on.

#include "visualizer/cli/options.hpp"

namespace rayscope::cli {

[[nodiscard]] int step(const StepOptions& options);
[[nodiscard]] int trace(const TraceOptions& options);
[[nodiscard]] int find(const FindCommandOptions& options);
[[nodiscard]] int diff(const DiffOptions& options);
[[nodiscard]] int render(const RenderCommandOptions& options);
[[nodiscard]] int explain(const ExplainOptions& options);
[[nodiscard]] int extents(const ExtentsOptions& options);
[[nodiscard]] int export_scene(const ExportOptions& options);
[[nodiscard]] int accuracy(const AccuracyCommandOptions& options);
[[nodiscard]] int cases(const CasesOptions& options);

} // namespace rayscope::cli
