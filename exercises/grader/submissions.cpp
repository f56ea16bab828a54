#include "exercises/grader/submissions.hpp"

#include "core/scene/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

bool is_own_file(const fs::path& path) { return fs::is_regular_file(fs::symlink_status(path)); }
bool is_own_folder(const fs::path& path) { return fs::is_directory(fs::symlink_status(path)); }

/// Also where the name ends in a slash.
std::string name_of(const fs::path& folder) {
    const fs::path whole = fs::absolute(folder).lexically_normal();
    return whole.has_filename() ? whole.filename() : whole.parent_path().filename();
}

Submission in_folder(const fs::path& folder, const std::vector<Exercise>& catalogue) {
    Submission found{name_of(folder), {}};
    for (const Exercise& exercise : catalogue)
        if (const fs::path file = folder / exercise.file_name(); is_own_file(file))
            found.files[exercise.id] = file;
    return found;
}

} // namespace

Submissions find_submissions(const std::vector<fs::path>& paths, const std::vector<Exercise>& catalogue) {
    Submissions found;
    for (const fs::path& path : paths) {
        if (fs::is_regular_file(path)) {
            const Exercise& exercise = find_exercise(catalogue, path.stem());
            found.list.push_back({name_of(fs::absolute(path).parent_path()), {{exercise.id, path}}});
            continue;
        }
        if (!fs::is_directory(path))
            throw InputError(path.string(), {}, "expected a file or a folder with submissions");
        if (Submission own = in_folder(path, catalogue); !own.files.empty()) {
            found.list.push_back(std::move(own));
            continue;
        }
        std::size_t students = 0;
        for (const auto& entry : fs::directory_iterator(path))
            if (is_own_folder(entry.path()) && !entry.path().filename().string().starts_with('.')) {
                found.list.push_back(in_folder(entry.path(), catalogue));
                ++students;
            }
        if (students == 0)
            throw InputError(
                path.string(), {},
                fmt::format("no submission is in it: expected a file like {}, or folders with such files",
                            catalogue.front().file_name()));
    }
    found.one = paths.size() == 1 && found.list.size() == 1 && !found.list.front().files.empty() &&
                (fs::is_regular_file(paths[0]) || name_of(paths[0]) == found.list.front().student);
    std::ranges::sort(found.list, {}, &Submission::student);
    const auto twice = std::ranges::adjacent_find(found.list, {}, &Submission::student);
    if (twice != found.list.end())
        throw InputError(twice->student, {}, "two submissions are of a student of this name");
    return found;
}

} // namespace rayscope::exercises
