#pragma once
// A trace into a file of the kind that its extension names.

#include "core/rayscope.hpp"

namespace rayscope::cli {

/// True for a file that is to hold the trace: .json, .html (a page), .webp (an animation) or .vtm (ParaView).
[[nodiscard]] bool is_trace_file(const std::string& file);

/// Asked before the work is done. Throws UsageError unless its extension is one of these and it can be written,
/// std::runtime_error where this build can't draw it.
/// @param option who names the file
void check_trace_file(const std::string& option, const std::string& file);

void write_trace_file(const Workbench& bench, const Trace& trace, const std::string& file);

} // namespace rayscope::cli
