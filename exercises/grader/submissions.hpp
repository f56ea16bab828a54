#pragma once
// Where students' files lie.

#include "exercises/grader/exercise.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rayscope::exercises {

/// What one student handed in.
struct Submission {
    std::string student;                                ///< the folder's name
    std::map<std::string, std::filesystem::path> files; ///< by the exercise's id
};

struct Submissions {
    std::vector<Submission> list; ///< ascending by student
    bool one = false;             ///< a single one was named, not a folder of them
};

/// Each path is a student's file (1-03-sphere.hpp), a student's folder with such files, or a folder of students'
/// folders. Links are not followed, so that nobody hands in what lies elsewhere.
/// Throws InputError where a path is none of these, or two students have the same name.
[[nodiscard]] Submissions find_submissions(const std::vector<std::filesystem::path>& paths,
                                           const std::vector<Exercise>& catalogue);

} // namespace rayscope::exercises
