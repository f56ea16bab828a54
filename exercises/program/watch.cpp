// Watches the student's files, checks on save, and listens to keys.

#include "exercises/program/checking.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/overview.hpp"
#include "exercises/program/screen.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <set>

#include <poll.h>
#include <sys/inotify.h>
#include <termios.h>
#include <unistd.h>

namespace rayscope::exercises {
namespace {

volatile std::sig_atomic_t stopped = 0;

/// Keys come at once and are not echoed, until the object is gone.
class KeyMode {
public:
    KeyMode() {
        tcgetattr(STDIN_FILENO, &before_);
        termios keys = before_;
        keys.c_lflag &= ~tcflag_t(ICANON | ECHO);
        tcsetattr(STDIN_FILENO, TCSANOW, &keys);
    }
    ~KeyMode() { tcsetattr(STDIN_FILENO, TCSANOW, &before_); }
    KeyMode(const KeyMode&) = delete;
    KeyMode& operator=(const KeyMode&) = delete;

private:
    termios before_{};
};

/// Tells which files of a folder were saved.
class SavedFiles {
public:
    explicit SavedFiles(const std::filesystem::path& folder)
        : notify_(inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
        // Editors write in place, or write a new file and move it over the old one.
        if (notify_ < 0 || inotify_add_watch(notify_, folder.c_str(), IN_CLOSE_WRITE | IN_MOVED_TO) < 0)
            throw std::runtime_error(
                fmt::format("can't watch {}: {}", folder.string(), std::strerror(errno)));
    }
    ~SavedFiles() { close(notify_); }
    SavedFiles(const SavedFiles&) = delete;
    SavedFiles& operator=(const SavedFiles&) = delete;

    [[nodiscard]] int descriptor() const { return notify_; }
    [[nodiscard]] std::set<std::string> take() const {
        std::set<std::string> names;
        alignas(inotify_event) std::array<char, 64 * (sizeof(inotify_event) + NAME_MAX + 1)> buffer;
        for (ssize_t count = 0; (count = read(notify_, buffer.data(), buffer.size())) > 0;)
            for (const char* at = buffer.data(); at < buffer.data() + count;) {
                const auto* event = reinterpret_cast<const inotify_event*>(at);
                if (event->len > 0) names.insert(event->name);
                at += sizeof(inotify_event) + event->len;
            }
        return names;
    }

private:
    int notify_;
};

class Watcher {
public:
    Watcher(const Context& context, const Workspace& workspace, const Toolchain& toolchain)
        : context_(context),
          workspace_(workspace),
          toolchain_(toolchain),
          current_(next_exercise(context.catalogue, workspace.progress())) {}

    [[nodiscard]] bool all_done() const { return current_ == nullptr; }

    /// Checks the current exercise and shows the result.
    bool check_current() {
        if (current_ == nullptr) {
            show(summary_text(context_.catalogue, workspace_.progress()));
            return true;
        }
        try {
            const Checked checked =
                check(context_, toolchain_, *current_, workspace_.file(*current_), &workspace_);
            show(checked.text);
            const Progress progress = workspace_.progress();
            if (next_exercise(context_.catalogue, progress) == nullptr)
                show(summary_text(context_.catalogue, progress));
            return checked.grade.all_right();
        } catch (const std::exception& error) { // a file that can't be read now may be saved again
            show(fmt::format("{}\n", error.what()));
            return false;
        }
    }

    void saved(const std::set<std::string>& names) {
        for (const Exercise& exercise : context_.catalogue)
            if (names.contains(exercise.file_name())) {
                current_ = &exercise;
                clear();
                check_current();
                prompt();
            }
    }

    /// False to quit.
    bool key(char pressed) {
        switch (pressed) {
        case 'q': return false;
        case 'n': {
            current_ = next_exercise(context_.catalogue, workspace_.progress());
            clear();
            show(next_text(context_.catalogue, workspace_));
            break;
        }
        case 'h':
            if (current_ != nullptr) show(hint_text(*current_, workspace_));
            break;
        case 'l': show(list_text(context_.catalogue, workspace_.progress(), Screen::of_stdout())); break;
        case 'c':
            for (const Exercise& exercise : context_.catalogue) {
                const Checked checked =
                    check(context_, toolchain_, exercise, workspace_.file(exercise), &workspace_);
                show(fmt::format("{:<6} {}\n", checked.grade.all_right() ? "right" : "", exercise.id));
            }
            show(summary_text(context_.catalogue, workspace_.progress()));
            break;
        case 'r':
            clear();
            check_current();
            break;
        case 'x':
            if (current_ == nullptr) break;
            if (!asked_) {
                show(fmt::format("Press x once more to put {} back to the stub (your file is kept).\n",
                                 current_->file_name()));
                asked_ = true;
                return true;
            }
            show(reset_text(*current_, workspace_));
            break;
        default: return true;
        }
        asked_ = false;
        prompt();
        return true;
    }

    void prompt() const {
        show(Screen::of_stdout().dim("\nn next  h hint  l list  c check all  r run again  x reset  q quit") +
             "\n");
    }

private:
    static void show(const std::string& text) {
        std::fputs(text.c_str(), stdout);
        std::fflush(stdout);
    }
    static void clear() { show("\033[2J\033[H"); }

    const Context& context_;
    const Workspace& workspace_;
    const Toolchain& toolchain_;
    const Exercise* current_;
    bool asked_ = false; ///< x was pressed once
};

} // namespace

int run(const Context& context, const Watch&) {
    const Workspace workspace = find_workspace(context.options.workspace);
    const auto toolchain = make_toolchain(context);
    Watcher watcher(context, workspace, *toolchain);
    // Nobody is there to save files or to press keys.
    if (isatty(STDIN_FILENO) == 0) return watcher.check_current() ? done : failed;

    const SavedFiles files(workspace.folder());
    struct sigaction action{};
    action.sa_handler = [](int) { stopped = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    sigaction(SIGHUP, &action, nullptr);
    const KeyMode keys;
    watcher.check_current();
    watcher.prompt();
    while (stopped == 0) {
        std::array<pollfd, 2> events{pollfd{STDIN_FILENO, POLLIN, 0}, {files.descriptor(), POLLIN, 0}};
        if (poll(events.data(), events.size(), -1) < 0) continue;
        if (events[1].revents != 0) watcher.saved(files.take());
        if (events[0].revents == 0) continue;
        char pressed = 'q';
        if (read(STDIN_FILENO, &pressed, 1) <= 0 || !watcher.key(pressed)) break;
    }
    return done;
}

} // namespace rayscope::exercises
