#pragma once
// What `find` found, as text; and how its conditions are read.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

/// Throws UsageError that begins with the command, shows the text, and marks the column.
[[nodiscard]] Expression expression_of(const std::string& command, const std::string& text,
                                       const Vocabulary& vocabulary);
/// Throws UsageError if it is a value.
void need_condition(const std::string& command, const Expression& expression);
/// Throws UsageError if it asks for places that only a stage looks into, and none was asked for.
void need_stage(const std::string& command, const Expression& expression, bool by_stage);

/// Of a pixel: the trace that `options` ask for.
[[nodiscard]] Trace trace_found(const Workbench& bench, const FindOptions& options, int x, int y);

/// The pixels at which it holds, row by row, at most so many.
struct FoundPixel {
    int x = 0, y = 0, events = 0;
};
[[nodiscard]] std::vector<FoundPixel> found_pixels(const FindResult& result, std::size_t most);

/// How many, where first, and which.
[[nodiscard]] std::string find_text(const Workbench& bench, const Expression& condition,
                                    const FindResult& result, const FindOptions& options, std::size_t listed,
                                    const StepStyle& style);

} // namespace rayscope::cli
