#pragma once
// What is written down of a graded submission: plain data, from which every report is made.

#include "exercises/grader/grade.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace rayscope::exercises {

struct GroupMark {
    std::string name;
    bool hidden = false;
    double score = 0;
    int points = 0, right = 0, cases = 0;
    std::string output; ///< for the student; of hidden groups it names no numbers
};

/// The recorded ray of a wrong case.
struct ShownRay {
    std::string scene, yours; ///< scene files' texts: the second is that of the answer, or empty
    std::string ray;          ///< as --ray takes it
    std::string note;         ///< what it shows, where the case itself has no ray
    std::string drawing;      ///< HTML: both runs
};

struct ExerciseMark {
    std::string id, title;
    bool handed_in = false, compiled = false;
    double score = 0;
    int points = 0;
    std::vector<GroupMark> groups;
    std::string misconception, says; ///< empty: none is known
    std::string problem;             ///< why it did not compile
    std::optional<ShownRay> ray;
    double limits_used = 0; ///< seconds: of the limits on time that were met
};

struct SubmissionMark {
    std::string student;
    double score = 0;
    int points = 0;
    std::vector<ExerciseMark> exercises;
};

/// @param handed_in false: the grade says nothing
[[nodiscard]] ExerciseMark mark_of(const Reference& reference, const Grade& grade, bool handed_in);
[[nodiscard]] SubmissionMark mark_of(std::string student, std::vector<ExerciseMark> exercises);

[[nodiscard]] nlohmann::json to_json(const SubmissionMark& mark);
/// Throws nlohmann::json::exception.
[[nodiscard]] SubmissionMark mark_from_json(const nlohmann::json& document);

/// The text of results.json as Gradescope reads it.
/// https://gradescope-autograders.readthedocs.io/en/latest/specs/#output-format
[[nodiscard]] std::string gradescope_text(const SubmissionMark& mark);

/// JUnit's XML: a suite for each student, a case for each group.
[[nodiscard]] std::string junit_text(const std::vector<SubmissionMark>& marks);

/// A line for each student: total, and points and misconception of each exercise.
[[nodiscard]] std::string class_csv(const std::vector<SubmissionMark>& marks);

/// A line for each group of each exercise: difficulty (mean share of the points), discrimination (correlation with the
/// rest of the student's points), and how often which misconception was found.
[[nodiscard]] std::string items_csv(const std::vector<SubmissionMark>& marks);

} // namespace rayscope::exercises
