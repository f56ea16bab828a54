#pragma once
// What two runs were asked, and what each answered, in words.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

/// "t of the hit, counted in lengths of the direction"
[[nodiscard]] std::string question_text(const Trace& first, const Trace& second,
                                        const Difference& difference);

/// The answer of one of the runs, whose trace this is.
[[nodiscard]] std::string answer_text(const Trace& trace, const Difference& difference, bool is_first,
                                      const Numbers& number);

} // namespace rayscope::cli
