#include "exercises/program/workspace.hpp"

#include "core/files/atomic_file.hpp"
#include "core/scene/source_text.hpp"
#include "exercises/program/failure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>
#include <cstdlib>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_bytes = std::size_t(1) << 20U;

fs::path home() {
    const char* value = std::getenv("HOME");
    if (value == nullptr || *value == '\0')
        throw UsageError("HOME is not set: say which folder, start DIR and --workspace DIR");
    return value;
}

/// Names the workspace that was started last.
fs::path remembered_file() {
    const char* state = std::getenv("XDG_STATE_HOME");
    const fs::path folder = state != nullptr && *state == '/' ? fs::path(state) : home() / ".local/state";
    return folder / "rayscope/exercises-workspace";
}

bool is_workspace(const fs::path& folder) { return fs::is_directory(folder / ".rayscope"); }

bool lies_within(const fs::path& path, const fs::path& folder) {
    const fs::path relative = fs::weakly_canonical(path).lexically_relative(fs::weakly_canonical(folder));
    return !relative.empty() && *relative.begin() != "..";
}

bool write_new(const fs::path& path, const std::string& text) {
    if (fs::exists(fs::symlink_status(path))) return false;
    write_text_file(path, text);
    return true;
}

Progress from_json(const nlohmann::json& document) {
    Progress progress;
    for (const auto& [id, entry] : document.at("exercises").items())
        progress[id] = {entry.at("best").get<double>(), entry.at("passed").get<bool>(),
                        entry.at("hints").get<int>()};
    return progress;
}

std::string to_text(const Progress& progress) {
    nlohmann::json document{{"version", 1}, {"exercises", nlohmann::json::object()}};
    for (const auto& [id, achievement] : progress)
        document["exercises"][id] = {
            {"best", achievement.best}, {"passed", achievement.passed}, {"hints", achievement.hints}};
    return document.dump(1) + "\n";
}

} // namespace

Progress Workspace::progress() const {
    const fs::path file = progress_file();
    if (!fs::exists(file)) return {};
    try {
        return from_json(nlohmann::json::parse(read_file(file, most_bytes)));
    } catch (const nlohmann::json::exception&) {
        const fs::path aside = file.string() + ".broken";
        std::error_code ignored;
        fs::rename(file, aside, ignored);
        std::fprintf(
            stderr,
            "rayscope: %s is no record of progress any more; it is now %s, and progress begins anew\n",
            file.c_str(), aside.c_str());
        return {};
    }
}

void Workspace::update(const std::function<void(Progress&)>& change) const {
    const int lock = ::open((own_folder() / "lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666);
    if (lock >= 0) flock(lock, LOCK_EX);
    Progress known = progress();
    change(known);
    write_text_file(progress_file(), to_text(known));
    if (lock >= 0) close(lock);
}

std::vector<fs::path> write_stubs(const fs::path& folder, const std::vector<Exercise>& catalogue) {
    fs::create_directories(folder / "tasks");
    std::vector<fs::path> written;
    const auto add = [&](const fs::path& path, const std::string& text) {
        if (write_new(path, text)) written.push_back(path);
    };
    for (const Exercise& exercise : catalogue) {
        add(folder / exercise.file_name(), read_file(exercise.stub(), most_bytes));
        add(folder / "tasks" / (exercise.id + ".md"), read_file(exercise.task(), most_bytes));
    }
    add(folder / "rx.hpp", read_file(fs::path(RAYSCOPE_EXERCISES) / "harness/rx.hpp", most_bytes));
    add(folder / "compile_flags.txt", "-std=c++20\n-xc++\n-I.\n"); // for editors
    return written;
}

std::vector<fs::path> start_workspace(const fs::path& folder, const std::vector<Exercise>& catalogue) {
    const fs::path source = fs::path(RAYSCOPE_EXERCISES).parent_path();
    if (lies_within(folder, source))
        throw UsageError(fmt::format(
            "{} lies in the source tree of rayscope; expected a folder of your own, for example {}",
            folder.string(), default_workspace().string()));
    if (fs::exists(folder) && !fs::is_directory(folder)) throw UsageError(folder.string() + " is no folder");
    fs::create_directories(folder / ".rayscope");
    const std::vector<fs::path> written = write_stubs(folder, catalogue);
    if (!fs::exists(folder / ".rayscope/progress.json")) Workspace(folder).update([](Progress&) {});
    const fs::path remembered = remembered_file();
    fs::create_directories(remembered.parent_path());
    write_text_file(remembered, fs::absolute(folder).lexically_normal().string() + "\n");
    return written;
}

Workspace find_workspace(const std::optional<fs::path>& asked) {
    const char* how = "start one with:  ./rayscope exercises start";
    if (asked) {
        if (is_workspace(*asked)) return Workspace(fs::absolute(*asked).lexically_normal());
        throw UsageError(fmt::format("{} is no workspace; {} {}", asked->string(), how, asked->string()));
    }
    for (fs::path folder = fs::current_path();; folder = folder.parent_path()) {
        if (is_workspace(folder)) return Workspace(folder);
        if (folder == folder.parent_path()) break;
    }
    if (const fs::path remembered = remembered_file(); fs::is_regular_file(remembered)) {
        std::string line = read_file(remembered, most_bytes);
        line = line.substr(0, line.find('\n'));
        if (is_workspace(line)) return Workspace(line);
    }
    throw UsageError(fmt::format("there is no workspace yet; {}", how));
}

fs::path default_workspace() { return home() / "rayscope-exercises"; }

} // namespace rayscope::exercises
