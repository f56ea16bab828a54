#include "visualizer/cli/picture_process.hpp"

#include "visualizer/cli/program_beside.hpp"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <vector>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace rayscope::cli {
namespace fs = std::filesystem;
namespace {

fs::path view_program() { return program_beside("rayscope-view"); }

/// Ctrl-C goes to the other program as well, which ends: this one must outlive it to tidy up.
class IgnoreInterrupts {
public:
    IgnoreInterrupts() : before_(std::signal(SIGINT, SIG_IGN)) {}
    ~IgnoreInterrupts() { std::signal(SIGINT, before_); }
    IgnoreInterrupts(const IgnoreInterrupts&) = delete;
    IgnoreInterrupts& operator=(const IgnoreInterrupts&) = delete;

private:
    void (*before_)(int);
};

/// Its exit code, or 128 + the signal that ended it.
int run(std::vector<std::string> arguments) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t default_signals;
    sigemptyset(&default_signals);
    sigaddset(&default_signals, SIGINT);
    posix_spawnattr_setsigdefault(&attributes, &default_signals);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    pid_t child = 0;
    const int error = posix_spawn(&child, pointers[0], nullptr, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    if (error != 0) throw std::runtime_error("can't run " + arguments[0] + ": " + std::strerror(error));
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) throw std::runtime_error("lost " + arguments[0] + ": " + std::strerror(errno));
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

void run_or_throw(std::vector<std::string> arguments) {
    const int code = run(std::move(arguments));
    if (code != 0)
        throw std::runtime_error("rayscope-view could not draw (exit code " + std::to_string(code) + ")");
}

const char* command_of(Drawing drawing) {
    switch (drawing) {
    case Drawing::png: return "png";
    case Drawing::pngs: return "pngs";
    case Drawing::webp: return "webp";
    case Drawing::vtm: break;
    }
    return "vtm";
}

void add_size(std::vector<std::string>& arguments, const std::optional<Size>& size) {
    if (!size) return;
    arguments.emplace_back("--size");
    arguments.push_back(std::to_string(size->width) + "x" + std::to_string(size->height));
}

fs::path folder_of_own() { return fs::temp_directory_path() / "rayscope-XXXXXX"; }

} // namespace

bool can_draw() { return access(view_program().c_str(), X_OK) == 0; }

const char* how_to_draw() {
    return "this build can't draw: rayscope-view is missing; it is built where VTK is installed (Debian: "
           "libvtk9-dev)";
}

void draw(Drawing drawing, const Trace& trace, const fs::path& output, std::optional<Size> size, int ray) {
    const IgnoreInterrupts patience;
    const TemporaryFolder folder(folder_of_own());
    const fs::path file = folder.path() / "trace.json";
    write_trace(trace, file);
    std::vector<std::string> arguments{view_program().string(),
                                       command_of(drawing),
                                       "--scene",
                                       trace.source.scene,
                                       "--trace",
                                       file.string(),
                                       "-o",
                                       output.string()};
    add_size(arguments, size);
    if (ray != none) {
        arguments.emplace_back("--ray");
        arguments.push_back(std::to_string(ray));
    }
    run_or_throw(std::move(arguments));
}

void draw_heat(const Map& map, const std::string& title, const fs::path& output) {
    const IgnoreInterrupts patience;
    const TemporaryFolder folder(folder_of_own());
    const fs::path file = folder.path() / "heat.pfm";
    write_map(map, file);
    run_or_throw({view_program().string(), "heat", file.string(), "--title", title, "-o", output.string()});
}

void draw_extents(const fs::path& scene, const fs::path& output, std::optional<Size> size) {
    const IgnoreInterrupts patience;
    std::vector<std::string> arguments{view_program().string(), "extents", "--scene",
                                       scene.string(),          "-o",      output.string()};
    add_size(arguments, size);
    run_or_throw(std::move(arguments));
}

void draw_accuracy(const fs::path& json) {
    const IgnoreInterrupts patience;
    run_or_throw({view_program().string(), "accuracy", json.string()});
}

void draw_effects(const fs::path& json) {
    const IgnoreInterrupts patience;
    run_or_throw({view_program().string(), "effects", json.string()});
}

} // namespace rayscope::cli
