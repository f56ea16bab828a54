#pragma once
// An exercise as its folder tells it.

#include "exercises/grader/value.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::exercises {

/// Cases that are worth points together.
struct Group {
    std::string name;
    int points = 0;
    bool hidden = false; ///< its cases are not shown to students
};

/// A wrong solution that is known, and what to say to those who wrote it.
struct Misconception {
    std::string name, says;
    std::vector<std::string> groups; ///< that it loses points in, all of them
    std::filesystem::path file;
};

/// A question to be answered before anything is run.
struct Prediction {
    std::string question, answer, reveal;
};

/// "Ray toObject(const Ray& r, const dmat4& M)" and the name in it.
struct Function {
    std::string signature, name;
};

struct Exercise {
    std::string id; ///< the folder's name: "1-01-to-object"
    std::filesystem::path folder;
    std::string title;
    int chapter = 0, points = 0;
    std::vector<Function> functions;
    std::vector<std::string> prerequisites, hints;
    std::string picture; ///< what the recorded ray shows
    std::string scene;   ///< a shipped scene that shows it, where cases have none of their own
    std::string formula; ///< which of the tracer's formulas it can stand for, if any
    Tolerance tolerance;
    std::vector<Group> groups;
    std::vector<Misconception> misconceptions;
    std::vector<Prediction> predictions;
    bool judged = false; ///< cases.cpp has a judge(): many answers are right
    bool shown =
        false; ///< cases.cpp has a show(): a scene and a ray for each case; of several functions show_NAME()

    [[nodiscard]] std::filesystem::path task() const { return folder / "README.md"; }
    [[nodiscard]] std::filesystem::path stub() const { return folder / "stub.hpp"; }
    [[nodiscard]] std::filesystem::path solution() const { return folder / "solution.hpp"; }
    [[nodiscard]] std::filesystem::path cases() const { return folder / "cases.cpp"; }
    /// How a student's file is called: "1-01-to-object.hpp".
    [[nodiscard]] std::string file_name() const { return id + ".hpp"; }
};

/// Throws InputError where the folder lacks a file, or exercise.toml is wrong.
[[nodiscard]] Exercise read_exercise(const std::filesystem::path& folder);

/// All exercises in a folder, in the order of their ids. Throws InputError.
[[nodiscard]] std::vector<Exercise> read_catalogue(const std::filesystem::path& folder);

/// "1-01", "to-object" or "1-01-to-object": the one exercise that is meant. Throws InputError that tells which there are.
[[nodiscard]] const Exercise& find_exercise(const std::vector<Exercise>& catalogue, const std::string& name);

} // namespace rayscope::exercises
