// A zip file for students, or for Gradescope.

#include "core/files/atomic_file.hpp"
#include "exercises/grader/child.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/workspace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <random>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

/// What run_autograder gives to `grade`, a word on each line.
std::string options_text(std::uint64_t seed, const std::vector<std::string>& exercises, bool unsafe) {
    std::string text = fmt::format("--seed\n{}\n{}", seed, unsafe ? "--unsafe\n" : "");
    for (const std::string& id : exercises) text += "--exercise\n" + id + "\n";
    return text;
}

/// The sources from which the grader is built.
void copy_sources(const fs::path& to) {
    const fs::path root = fs::path(RAYSCOPE_EXERCISES).parent_path();
    fs::create_directories(to);
    for (const char* name :
         {"CMakeLists.txt", "CMakePresets.json", "LICENSE", "cmake", "core", "exercises", "visualizer"})
        fs::copy(root / name, to / name, fs::copy_options::recursive);
}

/// Of all that is in the folder, with the same times whenever it is made.
void zip(const fs::path& folder, const fs::path& output) {
    std::vector<std::string> words{
        "env", "-C", folder.string(), "cmake",        "-E",
        "tar", "cf", "package.zip",   "--format=zip", "--mtime=2000-01-01 00:00:00"};
    std::vector<std::string> entries;
    for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path().filename());
    std::sort(entries.begin(), entries.end());
    words.insert(words.end(), entries.begin(), entries.end());
    Child child(words, {}, Child::Errors::with_output);
    const auto ended = child.finish(4096, std::chrono::minutes(2));
    if (!ended || ended->code != 0)
        throw std::runtime_error("can't make the zip file: " +
                                 (ended ? ended->output : "cmake does not end"));
    AtomicFile file(output);
    fs::copy_file(folder / "package.zip", file.temporary(), fs::copy_options::overwrite_existing);
    file.commit();
}

std::uint64_t random_seed() {
    std::random_device device;
    return (std::uint64_t(device()) << 31U) ^ device();
}

} // namespace

int run(const Context& context, const Package& command) {
    if (command.output.extension() != ".zip")
        throw UsageError(
            fmt::format("-o: expected a file that ends in .zip, found '{}'", command.output.string()));
    check_writable(command.output);
    const PrivateFolder folder(cache_folder());
    if (command.student) {
        write_stubs(folder.path(), context.catalogue);
        zip(folder.path(), command.output);
        std::printf("%s: stubs and tasks, no solutions and no cases\n", command.output.c_str());
        return done;
    }
    std::vector<std::string> ids;
    for (const std::string& name : command.exercises)
        ids.push_back(find_exercise(context.catalogue, name).id);
    if (ids.empty())
        for (const Exercise& exercise : context.catalogue) ids.push_back(exercise.id);
    const std::uint64_t seed = context.options.seed.value_or(random_seed());
    copy_sources(folder.path() / "rayscope");
    for (const char* name : {"setup.sh", "run_autograder"})
        fs::copy_file(fs::path(RAYSCOPE_EXERCISES) / "gradescope" / name, folder.path() / name);
    write_text_file(folder.path() / "options", options_text(seed, ids, context.options.unsafe));
    zip(folder.path(), command.output);
    std::printf(
        "%s: an autograder for %zu exercises. It holds solutions and the seed %llu: for instructors only.\n",
        command.output.c_str(), ids.size(), static_cast<unsigned long long>(seed));
    return done;
}

} // namespace rayscope::exercises
