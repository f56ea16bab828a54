#pragma once
// A trace as one file for a browser: everything in it, nothing fetched.

#include "core/rayscope.hpp"

#include <filesystem>
#include <string>

namespace rayscope::page {

/// The whole file. Its element "trace" holds the trace's JSON, its element "scene" what is drawn around the rays.
/// @param bench of the trace
[[nodiscard]] std::string page_text(const Workbench& bench, const Trace& trace);

/// Complete or not at all. Throws std::runtime_error.
void write_page(const Workbench& bench, const Trace& trace, const std::filesystem::path& path);

} // namespace rayscope::page
