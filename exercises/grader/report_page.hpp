#pragma once
// A student's report as one page that needs nothing else.

#include "exercises/grader/results.hpp"

#include <filesystem>

namespace rayscope::exercises {

/// @param rays the folder with the scene of each wrong case, ID.toml
[[nodiscard]] std::string report_page(const SubmissionMark& mark, const std::filesystem::path& rays);

} // namespace rayscope::exercises
