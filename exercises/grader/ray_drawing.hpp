#pragma once
// A recorded ray as it stands in a page: that of the right answer, and over it the student's.

#include "exercises/grader/shown_case.hpp"

#include <string>

namespace rayscope::exercises {

/// For the page's <style>: lines, bars and the legend tell both runs apart by their shape, too.
extern const char* const ray_drawing_style;

/// HTML without anything from outside: a legend, the way of the ray, its inside intervals, where both runs part in words,
/// and the rays as tables.
[[nodiscard]] std::string drawn_runs(const ShownRuns& runs);

} // namespace rayscope::exercises
