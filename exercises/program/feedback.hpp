#pragma once
// What a student is told about a file.

#include "exercises/grader/grade.hpp"
#include "exercises/program/screen.hpp"

namespace rayscope::exercises {

/// The command that opens a recorded ray.
struct RayCommand {
    std::string command;
    std::string note; ///< what the ray shows, where the case itself has none
};

struct Feedback {
    bool show_hidden = false;      ///< for instructors
    std::string code;              ///< the student's file, to show lines of it
    std::optional<RayCommand> ray; ///< of the case that is told
};

/// The case that is told: the first wrong one that may be shown.
[[nodiscard]] std::optional<std::size_t> told_case(const Reference& reference, const Grade& grade,
                                                   bool show_hidden);

[[nodiscard]] std::string feedback_text(const Reference& reference, const Grade& grade,
                                        const Feedback& feedback, const Screen& screen);

} // namespace rayscope::exercises
