#include "exercises/grader/toolchain.hpp"

#include "core/files/atomic_file.hpp"
#include "core/math/hash.hpp"
#include "core/scene/source_text.hpp"
#include "exercises/grader/child.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr const char* compiler = "g++";
constexpr std::size_t most_output = std::size_t(1) << 16U, most_source = std::size_t(1) << 20U;
constexpr std::uint64_t compile_seconds = 20;
constexpr std::chrono::seconds compile_wall{60};
constexpr std::uint64_t compile_memory = std::uint64_t(2) << 30U, program_bytes = std::uint64_t(64) << 20U,
                        parts_bytes = std::uint64_t(512) << 20U;

const std::vector<std::string> flags{"-std=c++20",
                                     "-O1",
                                     "-ffp-contract=off", // rounding errors are part of the lesson
                                     "-Wall",
                                     "-Wextra",
                                     "-Wno-unused-parameter",
                                     "-fdiagnostics-plain-output",
                                     "-fmax-errors=20",
                                     "-ftemplate-depth=256",
                                     "-pipe"};
const std::vector<std::string> sanitizers{"-g1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"};

constexpr const char* harness_files[] = {"rx.hpp",   "wire.hpp",        "cases.hpp",         "scene_text.hpp",
                                         "wire.cpp", "answer_main.cpp", "reference_main.cpp"};

std::string hash_of(const std::string& text) {
    return fmt::format("{:016x}", Fnv1a().add(text.data(), text.size()).value());
}

std::string compiler_version() {
    Child child({compiler, "--version"}, {}, Child::Errors::with_output);
    const auto ended = child.finish(most_output, compile_wall);
    if (!ended || ended->code != 0) throw std::runtime_error("no compiler: g++ is needed (package g++)");
    return ended->output;
}

/// Waits for its turn; other processes that build the same wait, too.
class FileLock {
public:
    explicit FileLock(const fs::path& path)
        : file_(::open(path.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
        if (file_ >= 0) flock(file_, LOCK_EX);
    }
    ~FileLock() {
        if (file_ >= 0) close(file_);
    }
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

private:
    int file_;
};

std::vector<Diagnostic> diagnostics_of(const std::string& output, const std::string& file) {
    static const std::regex pattern(
        R"re(^([^:]+):(\d{1,7}):(\d{1,7}): (fatal error|error|warning): (.*)$)re");
    std::vector<Diagnostic> found;
    std::istringstream lines(output);
    for (std::string line; std::getline(lines, line);) {
        if (line.size() > 1000) line.resize(1000); // the pattern's cost
        std::smatch match;
        if (!std::regex_match(line, match, pattern) || match[1] != file) continue;
        found.push_back({std::stoi(match[2]), std::stoi(match[3]), match[4] != "warning", match[5]});
    }
    return found;
}

/// What the linker or the compiler says where no line of the student's own is named.
std::string problem_of(const std::string& output, int code) {
    static const std::regex undefined(R"re(undefined reference to `([^']{1,400})')re"),
        twice(R"re(multiple definition of `([^']{1,400})')re"),
        any(R"re((?:^|\n)[^\n]{0,400}error: ([^\n]{0,400}))re");
    const std::string text = output.substr(0, most_output);
    std::smatch match;
    if (std::regex_search(text, match, twice))
        return fmt::format("the file defines {}, which is there already", match[1].str());
    if (std::regex_search(text, match, undefined))
        return fmt::format(
            "the file does not define {} (a different type of a parameter makes a different function)",
            match[1].str());
    if (text.find("cc1plus: out of memory") != std::string::npos || text.find("Killed") != std::string::npos)
        return "the compiler needed more memory or time than it is given";
    if (std::regex_search(text, match, any)) return match[1];
    return fmt::format("the compiler ended with code {}", code);
}

void write_file(const fs::path& path, const std::string& text) { write_text_file(path, text); }

} // namespace

fs::path cache_folder() {
    const auto given = [](const char* name) -> fs::path {
        const char* value = std::getenv(name);
        return value != nullptr ? value : "";
    };
    if (const fs::path own = given("RAYSCOPE_EXERCISES_CACHE"); !own.empty()) return own;
    if (const fs::path user = given("XDG_CACHE_HOME"); user.is_absolute()) return user / "rayscope/exercises";
    if (const fs::path home = given("HOME"); home.is_absolute()) return home / ".cache/rayscope/exercises";
    return fs::temp_directory_path() / fmt::format("rayscope-exercises-{}", getuid());
}

PrivateFolder::PrivateFolder(const fs::path& beside)
    : TemporaryFolder((fs::create_directories(beside), beside / "work-XXXXXX")) {}

Toolchain::Toolchain(fs::path harness, fs::path runner, Safety safety)
    : harness_(std::move(harness)), runner_(std::move(runner)), safety_(safety) {
    std::string key = compiler_version();
    for (const std::string& flag : flags) key += flag;
    for (const char* name : harness_files) key += read_file(harness_ / name, most_source);
    cache_ = cache_folder() / hash_of(key);
    fs::create_directories(parts());
    build_parts(false);
}

std::string Toolchain::parts_inside(bool sanitized) const {
    return (safety_ == Safety::sandboxed ? fs::path("/rx") : parts()) / (sanitized ? "sanitized" : "plain");
}

std::string Toolchain::run_compiler(const std::vector<std::string>& arguments, const fs::path& work,
                                    std::uint64_t most_bytes, int& code) const {
    std::vector<std::string> command{std::string("/usr/bin/") + compiler};
    command.insert(command.end(), arguments.begin(), arguments.end());
    if (safety_ == Safety::sandboxed)
        command = confined_tools({{parts(), "/rx"}, {work, "/unit", true}}, "/unit", command);
    else
        command.insert(command.begin(),
                       {"env", "-C", work.string(), "-u", "CPATH", "-u", "CPLUS_INCLUDE_PATH"});
    Child child(command, {compile_seconds, compile_memory, most_bytes}, Child::Errors::with_output);
    const auto ended = child.finish(most_output, compile_wall);
    code = ended ? ended->code : -1;
    return ended ? ended->output : "Killed";
}

void Toolchain::build_parts(bool sanitized) const {
    const std::string inside = parts_inside(sanitized);
    const fs::path folder = parts() / fs::path(inside).filename(), done = folder / "done";
    if (fs::exists(done)) return;
    fs::create_directories(folder);
    const FileLock lock(folder / "lock");
    if (fs::exists(done)) return;
    for (const char* name : harness_files) write_file(folder / name, read_file(harness_ / name, most_source));
    const PrivateFolder work(cache_);
    const auto make = [&](std::vector<std::string> words, const std::string& result) {
        words.insert(words.begin(), flags.begin(), flags.end());
        if (sanitized) words.insert(words.end(), sanitizers.begin(), sanitizers.end());
        words.insert(words.end(), {"-I" + inside, "-o", result});
        int code = 0;
        const std::string output = run_compiler(words, work.path(), parts_bytes, code);
        if (code != 0)
            throw std::runtime_error("can't compile what exercises need (g++, libglm-dev):\n" + output);
        fs::rename(work.path() / result, folder / result);
    };
    for (const char* name : {"wire", "answer_main", "reference_main"})
        make({"-c", inside + "/" + name + ".cpp"}, std::string(name) + ".o");
    make({"-x", "c++-header", inside + "/rx.hpp"}, "rx.hpp.gch");
    write_file(done, "all parts are there\n");
}

Compiled Toolchain::compile(const Unit& unit, const fs::path& to) const {
    if (unit.sanitized) build_parts(true);
    const PrivateFolder work(cache_);
    for (const SourceFile& file : unit.files) write_file(work.path() / file.name, file.text);
    const std::string inside = parts_inside(unit.sanitized);
    std::vector<std::string> words = flags;
    if (unit.sanitized)
        words.insert(words.end(), sanitizers.begin(), sanitizers.end());
    else
        words.emplace_back("-static");
    words.insert(words.end(), {"-I" + inside, unit.files.front().name, "-o", "program", inside + "/wire.o",
                               inside + (unit.reference ? "/reference_main.o" : "/answer_main.o")});
    int code = 0;
    const std::string output = run_compiler(words, work.path(), program_bytes, code);
    Compiled result;
    result.diagnostics = diagnostics_of(output, unit.about);
    if (code == 0 && fs::is_regular_file(fs::symlink_status(work.path() / "program"))) {
        constexpr fs::perms run_by_all = fs::perms::owner_all | fs::perms::group_read |
                                         fs::perms::group_exec | fs::perms::others_read |
                                         fs::perms::others_exec;
        fs::permissions(work.path() / "program", run_by_all);
        fs::rename(work.path() / "program", to);
        result.program = to;
        return result;
    }
    const bool told = std::ranges::any_of(result.diagnostics, &Diagnostic::error);
    if (!told) result.problem = problem_of(output, code);
    return result;
}

Compiled Toolchain::kept(const Unit& unit) const {
    std::string key;
    for (const SourceFile& file : unit.files) key += file.name + '\0' + file.text + '\0';
    const fs::path to = cache_ / (hash_of(key) + (unit.sanitized ? "-sanitized" : ""));
    const FileLock lock(to.string() + ".lock");
    if (fs::exists(to)) return {to, {}, {}};
    return compile(unit, to);
}

} // namespace rayscope::exercises
