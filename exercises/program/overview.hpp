#pragma once
// What a student has, and what comes next, as text.

#include "exercises/program/screen.hpp"
#include "exercises/program/workspace.hpp"

namespace rayscope::exercises {

/// The first that is not passed and whose prerequisites are, or else the first that is not passed; none if all are.
[[nodiscard]] const Exercise* next_exercise(const std::vector<Exercise>& catalogue, const Progress& progress);

[[nodiscard]] std::string list_text(const std::vector<Exercise>& catalogue, const Progress& progress,
                                    const Screen& screen);
/// "3 of 28 exercises are right: 35 of 800 points."
[[nodiscard]] std::string summary_text(const std::vector<Exercise>& catalogue, const Progress& progress);
/// The task of the next exercise and the file to change, or that all is done.
[[nodiscard]] std::string next_text(const std::vector<Exercise>& catalogue, const Workspace& workspace);

/// One hint more than the last time; enters that.
[[nodiscard]] std::string hint_text(const Exercise& exercise, const Workspace& workspace);
/// Puts the stub in place of the student's file, which is kept; says where.
[[nodiscard]] std::string reset_text(const Exercise& exercise, const Workspace& workspace);

/// True if the answer is the right one: as a number within 1 %, or else as text, whatever its blanks and case.
[[nodiscard]] bool predicted(const Prediction& prediction, const std::string& answer);

} // namespace rayscope::exercises
