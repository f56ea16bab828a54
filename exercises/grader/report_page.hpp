#pragma once
// A student's report as one page that needs nothing else.

#include "exercises/grader/results.hpp"

#include <string>

namespace rayscope::exercises {

/// It names the scenes of wrong cases that lie beside it: rays/ID.toml and rays/ID.yours.toml.
[[nodiscard]] std::string report_page(const SubmissionMark& mark);

} // namespace rayscope::exercises
