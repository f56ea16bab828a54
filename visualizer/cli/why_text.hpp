#pragma once
// Why a ray did not end on an object.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

/// The drawn object of that name: an index into Scene::drawn. Throws UsageError with near matches.
[[nodiscard]] std::size_t find_drawn(const Scene& scene, const std::string& name);

/// One sentence with its numbers, such as "bowl: the ray's line misses it".
[[nodiscard]] std::string why_text(const Workbench& bench, const Trace& trace, int ray, std::size_t object,
                                   const Numbers& number);

/// That sentence for each ray of the trace, a line each.
[[nodiscard]] std::string why_list(const Workbench& bench, const Trace& trace, std::size_t object,
                                   const StepStyle& style);

} // namespace rayscope::cli
