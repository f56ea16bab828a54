#include "exercises/grader/child.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayscope::exercises {
namespace {

constexpr int not_found = 127;

std::array<int, 2> new_pipe() {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
        throw std::runtime_error(fmt::format("can't make a pipe: {}", std::strerror(errno)));
    return ends;
}

void limit(__rlimit_resource what, const std::optional<std::uint64_t>& most) {
    if (!most) return;
    const rlimit both{*most, *most};
    setrlimit(what, &both);
}

using Clock = std::chrono::steady_clock;

int milliseconds_until(Clock::time_point end) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    return left > 0 ? int(left) : 0;
}

/// Adds what can be read; false at the end, or when the time is over.
bool take(int from, std::string& text, std::size_t most, Clock::time_point end) {
    pollfd event{from, POLLIN, 0};
    while (poll(&event, 1, milliseconds_until(end)) < 0)
        if (errno != EINTR) return false;
    if (event.revents == 0) return false;
    std::array<char, 65536> part;
    const ssize_t count = ::read(from, part.data(), std::min(part.size(), most));
    if (count <= 0) return count < 0 && errno == EINTR;
    text.append(part.data(), std::size_t(count));
    return true;
}

} // namespace

Child::Child(const std::vector<std::string>& words, const ChildLimits& limits, Errors errors) {
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    const auto in = new_pipe(), out = new_pipe();
    const pid_t self = getpid();
    process_ = fork();
    if (process_ == 0) {
        setpgid(0, 0); // so that the whole family can be killed, and Ctrl-C reaches only this program
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (getppid() != self) _exit(not_found); // it ended before this could be asked for
        dup2(in[0], STDIN_FILENO);
        dup2(out[1], STDOUT_FILENO);
        if (errors == Errors::with_output) dup2(out[1], STDERR_FILENO);
        const rlimit no_core{0, 0};
        setrlimit(RLIMIT_CORE, &no_core);
        limit(RLIMIT_CPU, limits.cpu_seconds);
        limit(RLIMIT_AS, limits.memory_bytes);
        limit(RLIMIT_FSIZE, limits.file_bytes);
        execvp(arguments[0], arguments.data());
        _exit(not_found);
    }
    const int error = errno;
    ::close(in[0]);
    ::close(out[1]);
    input_ = in[1];
    output_ = out[0];
    if (process_ < 0)
        throw std::runtime_error(fmt::format("can't start {}: {}", words[0], std::strerror(error)));
}

Child::~Child() {
    close_input();
    if (output_ >= 0) ::close(output_);
    if (process_ <= 0) return;
    kill(-process_, SIGKILL);
    kill(process_, SIGKILL); // before it has a group of its own
    waitpid(process_, nullptr, 0);
}

bool Child::write(std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(input_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return false;
        bytes.remove_prefix(std::size_t(count));
    }
    return true;
}

void Child::close_input() {
    if (input_ >= 0) ::close(input_);
    input_ = -1;
}

std::optional<std::string> Child::read(std::size_t count, std::chrono::milliseconds at_most) {
    const auto end = Clock::now() + at_most;
    std::string text;
    while (text.size() < count)
        if (!take(output_, text, count - text.size(), end)) return std::nullopt;
    return text;
}

std::optional<Child::Ended> Child::finish(std::size_t most_output, std::chrono::milliseconds at_most) {
    close_input();
    const auto end = Clock::now() + at_most;
    Ended ended;
    for (std::string part; take(output_, part, 65536, end); part.clear())
        if (ended.output.size() < most_output)
            ended.output += part.substr(0, most_output - ended.output.size());
    if (Clock::now() >= end) return std::nullopt;
    int status = 0;
    while (waitpid(process_, &status, 0) < 0)
        if (errno != EINTR) return std::nullopt;
    process_ = -1;
    ended.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return ended;
}

} // namespace rayscope::exercises
