#pragma once
// A student's own folder: one file for each exercise, and what was achieved.

#include "exercises/grader/exercise.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rayscope::exercises {

/// What a student has achieved in one exercise.
struct Achievement {
    double best = 0; ///< points
    bool passed = false;
    int hints = 0; ///< that were shown
};
using Progress = std::map<std::string, Achievement>;

class Workspace {
public:
    explicit Workspace(std::filesystem::path folder) : folder_(std::move(folder)) {}

    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::filesystem::path file(const Exercise& exercise) const {
        return folder_ / exercise.file_name();
    }
    /// For what the program writes by itself.
    [[nodiscard]] std::filesystem::path own_folder() const { return folder_ / ".rayscope"; }

    /// A file that can't be read is put aside, and progress begins anew.
    [[nodiscard]] Progress progress() const;
    /// Reads, changes and writes it, while no other process does. A crash leaves the old or the new state.
    void update(const std::function<void(Progress&)>& change) const;

private:
    [[nodiscard]] std::filesystem::path progress_file() const { return own_folder() / "progress.json"; }
    std::filesystem::path folder_;
};

/// The stubs of all exercises in a new or an old folder; files that are there stay as they are.
/// Throws UsageError for a folder in the project's own source tree.
/// @return the files that were written
std::vector<std::filesystem::path> start_workspace(const std::filesystem::path& folder,
                                                   const std::vector<Exercise>& catalogue);

/// The one that is asked for, or that the current folder lies in, or that was started last.
/// Throws UsageError that says how to start one.
[[nodiscard]] Workspace find_workspace(const std::optional<std::filesystem::path>& asked);

/// The files of a workspace alone. @return those that were not there
std::vector<std::filesystem::path> write_stubs(const std::filesystem::path& folder,
                                               const std::vector<Exercise>& catalogue);

/// Where `start` makes one if nobody says where.
[[nodiscard]] std::filesystem::path default_workspace();

} // namespace rayscope::exercises
