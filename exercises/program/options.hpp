#pragma once
// What the command line says.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rayscope::exercises {

struct Start {
    std::optional<std::filesystem::path> folder;
};
struct Watch {};
struct ListExercises {};
struct Check {
    std::string name; ///< of an exercise, or a file
};
struct CheckAll {};
struct Hint {
    std::optional<std::string> name;
};
struct Reset {
    std::string name;
    bool yes = false;
};
struct ShowSolution {
    std::string name;
};
struct Next {};
struct Predict {
    std::optional<std::string> name;
};
struct Verify {
    std::vector<std::string> names;
    int seeds = 3;
    int jobs = 0;
};
struct GradeAll {
    std::vector<std::filesystem::path> submissions;
    std::vector<std::string> exercises; ///< empty: all that anybody handed in
    std::filesystem::path output;
    int jobs = 0;
};
struct Package {
    bool student = false;
    std::vector<std::string> exercises; ///< of the autograder; empty: all
    std::filesystem::path output;
};
struct New {
    std::filesystem::path folder;
    std::optional<std::filesystem::path> trace;
    std::optional<int> event;
};
struct RenderWith {
    std::string scene, with;
    std::filesystem::path output = "rayscope-with.png";
    std::optional<std::string> size;
};
struct StepWith {
    std::string scene, with;
    std::optional<std::string> pixel, ray, size;
};
/// Help, already answered: the text goes to stdout.
struct Help {
    std::string text;
};

using Command = std::variant<Help, Start, Watch, ListExercises, Check, CheckAll, Hint, Reset, ShowSolution,
                             Next, Predict, Verify, GradeAll, Package, New, RenderWith, StepWith>;

struct Options {
    Command command;
    bool unsafe = false, instructor = false;
    std::optional<std::uint64_t> seed;
    std::optional<std::filesystem::path> workspace, catalogue;
};

/// Throws UsageError.
[[nodiscard]] Options parse_options(int count, const char* const* arguments);

} // namespace rayscope::exercises
