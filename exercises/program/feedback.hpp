#pragma once
// What a student is told about a file.

#include "exercises/grader/grade.hpp"
#include "exercises/program/screen.hpp"

namespace rayscope::exercises {

struct Feedback {
    bool show_hidden = false;       ///< for instructors
    std::string code;               ///< the student's file, to show lines of it
    std::optional<std::string> ray; ///< the command that opens the recorded ray of the case
};

/// The case that is told: the first wrong one that may be shown.
[[nodiscard]] std::optional<std::size_t> told_case(const Reference& reference, const Grade& grade,
                                                   bool show_hidden);

[[nodiscard]] std::string feedback_text(const Reference& reference, const Grade& grade,
                                        const Feedback& feedback, const Screen& screen);

} // namespace rayscope::exercises
