#include "tests/cli/program.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>

#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayscope::test {
namespace {

constexpr std::chrono::seconds patience{60}; // sanitizers on a busy machine

/// In the new process: becomes the program, or exits with 127.
[[noreturn]] void become_program(const std::vector<std::string>& arguments, const Setting& setting) {
    std::vector<std::string> words{RAYSCOPE_PROGRAM};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    for (const std::string& variable : setting.environment) {
        const auto at = variable.find('=');
        setenv(variable.substr(0, at).c_str(), variable.substr(at + 1).c_str(), 1);
    }
    if (setting.largest_file) {
        const rlimit limit{*setting.largest_file, *setting.largest_file};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    if (chdir(setting.folder.c_str()) == 0) execv(pointers[0], pointers.data());
    _exit(127);
}

int code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status); }

void redirect(int descriptor, const std::filesystem::path& path, int flags) {
    const int file = ::open(path.c_str(), flags, 0600);
    if (file < 0 || dup2(file, descriptor) < 0) _exit(126);
}

} // namespace

Outcome run_program(const std::vector<std::string>& arguments, const Setting& setting) {
    const TemporaryFolder folder;
    const auto out = folder.path() / "out", err = folder.path() / "err";
    const pid_t process = fork();
    if (process == 0) {
        redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
        redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT);
        redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT);
        become_program(arguments, setting);
    }
    int status = 0;
    waitpid(process, &status, 0);
    return {code_of(status), content_of(out), content_of(err)};
}

TerminalProgram::TerminalProgram(const std::vector<std::string>& arguments, const Setting& setting) {
    const winsize size{24, 80, 0, 0};
    process_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (process_ == 0) {
        setenv("TERM", "xterm", 1);
        unsetenv("NO_COLOR");
        become_program(arguments, setting);
    }
}

TerminalProgram::~TerminalProgram() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    close(terminal_);
}

void TerminalProgram::type(const std::string& keys) {
    EXPECT_EQ(write(terminal_, keys.data(), keys.size()), ssize_t(keys.size()));
}

bool TerminalProgram::read_more(std::chrono::steady_clock::time_point deadline) {
    const auto left =
        std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd waiting{terminal_, POLLIN, 0};
    if (left.count() <= 0 || poll(&waiting, 1, int(left.count())) <= 0) return false;
    char bytes[4096];
    const ssize_t count = read(terminal_, bytes, sizeof bytes);
    closed_ = count <= 0;
    if (closed_) return false;
    buffer_.append(bytes, std::size_t(count));
    return true;
}

std::string TerminalProgram::shown_until(const std::string& text) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (buffer_.find(text) == std::string::npos)
        if (!read_more(deadline)) {
            ADD_FAILURE() << "not shown: " << text << "\nbut:\n" << buffer_;
            return std::exchange(buffer_, "");
        }
    const std::size_t end = buffer_.find(text) + text.size();
    const std::string shown = buffer_.substr(0, end);
    buffer_.erase(0, end);
    return shown;
}

int TerminalProgram::code(const std::string& nudge) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    // What is typed while the terminal changes its mode can be lost or garbled: so it is typed again.
    for (auto again = std::chrono::steady_clock::now(); !nudge.empty() && !closed_ && again < deadline;) {
        type(nudge);
        again += std::chrono::seconds(1);
        while (read_more(again)) {
        }
    }
    while (read_more(deadline)) {
    }
    if (std::chrono::steady_clock::now() >= deadline) {
        ADD_FAILURE() << "it does not end; it showed:\n" << buffer_;
        return -1;
    }
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return code_of(status);
}

} // namespace rayscope::test
