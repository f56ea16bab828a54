#include "exercises/runner/one_run.hpp"

#include "exercises/runner/allowed_calls.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <ctime>

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayscope::runner {
namespace {

constexpr rlim_t most_memory = rlim_t(512) << 20U, most_stack = rlim_t(8) << 20U;
constexpr std::size_t most_answer = std::size_t(1) << 20U;
constexpr std::size_t kept_print = 4096, most_print = std::size_t(16) << 20U;
constexpr int answers = 3; // descriptor of the program
constexpr int not_started = 126;

class Descriptor {
public:
    explicit Descriptor(int number = -1) : number_(number) {}
    Descriptor(Descriptor&& other) noexcept : number_(other.number_) { other.number_ = -1; }
    Descriptor& operator=(Descriptor&&) = delete;
    ~Descriptor() { shut(); }
    void shut() {
        if (number_ >= 0) close(number_);
        number_ = -1;
    }
    [[nodiscard]] int get() const { return number_; }

private:
    int number_;
};

struct Pipe {
    Descriptor out, in;
};
Pipe new_pipe() {
    std::array<int, 2> ends{-1, -1};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return {Descriptor(), Descriptor()};
    return {Descriptor(ends[0]), Descriptor(ends[1])};
}

Descriptor file_with(const std::string& content) {
    Descriptor file(memfd_create("input", MFD_CLOEXEC));
    std::size_t done = 0;
    while (done < content.size()) {
        const ssize_t count = write(file.get(), content.data() + done, content.size() - done);
        if (count <= 0) return Descriptor();
        done += std::size_t(count);
    }
    lseek(file.get(), 0, SEEK_SET);
    return file;
}

void limit(__rlimit_resource what, rlim_t most) {
    const rlimit both{most, most};
    setrlimit(what, &both);
}

/// For code that nobody trusts; false where the system can't give them.
bool set_limits() {
    limit(RLIMIT_STACK, most_stack);
    limit(RLIMIT_AS, most_memory);
    limit(RLIMIT_FSIZE, 0);
    limit(RLIMIT_NOFILE, 16);
    return allow_only_computing();
}

[[noreturn]] void start(const std::string& program, const std::vector<std::string>& given) {
    std::vector<std::string> copies = given;
    std::vector<char*> words{const_cast<char*>(program.c_str())};
    for (std::string& word : copies) words.push_back(word.data());
    words.push_back(nullptr);
    std::array<char*, 1> nothing{nullptr};
    execve(program.c_str(), words.data(), nothing.data());
    _exit(not_started);
}

[[noreturn]] void become(const Run& what, const Limits& limits, int input, int print, int answer) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Above the numbers that they are to get, so that none is overwritten before it is copied.
    const int in = fcntl(input, F_DUPFD, 10), out = fcntl(print, F_DUPFD, 10),
              result = fcntl(answer, F_DUPFD, 10);
    if (dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(out, 2) < 0 || dup2(result, answers) < 0)
        _exit(not_started);
    if (syscall(SYS_close_range, answers + 1, ~0U, 0) != 0) _exit(not_started);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, rlim_t(limits.cpu.count() / 1000) + 2);
    if (limits.computing_only && !set_limits()) _exit(not_started);
    start(what.program, what.words);
}

std::chrono::nanoseconds cpu_time(pid_t process) {
    clockid_t clock{};
    timespec time{};
    if (clock_getcpuclockid(process, &clock) != 0 || clock_gettime(clock, &time) != 0) return {};
    return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
}

/// Takes what a pipe holds now; false once it is closed.
bool take(int pipe, std::string& text, std::size_t kept, std::size_t& total) {
    std::array<char, 65536> part;
    const ssize_t count = read(pipe, part.data(), part.size());
    if (count <= 0) return false;
    total += std::size_t(count);
    if (text.size() < kept) text.append(part.data(), std::min(std::size_t(count), kept - text.size()));
    return true;
}

/// Watches the child until it ends or passes a limit; then it is dead.
End watch(pid_t child, Pipe& print, Pipe& answer, const Limits& limits) {
    End end;
    const Descriptor handle(int(syscall(SYS_pidfd_open, child, 0)));
    std::size_t printed = 0, answered = 0;
    std::array<pollfd, 3> events{
        pollfd{handle.get(), POLLIN, 0}, {print.out.get(), POLLIN, 0}, {answer.out.get(), POLLIN, 0}};
    const auto start = std::chrono::steady_clock::now();
    const auto drain = [&](pollfd& event, std::string& text, std::size_t kept, std::size_t& total) {
        if (event.revents != 0 && !take(event.fd, text, kept, total)) event.fd = -1;
    };
    bool over = false;
    while (!over) {
        poll(events.data(), events.size(), 10);
        over = events[0].revents != 0;
        do { // what an ended child left in the pipes is read to the end
            drain(events[1], end.printed, kept_print, printed);
            drain(events[2], end.answer, most_answer, answered);
            if (printed > most_print || answered > most_answer) end.how = 'o';
        } while (over && end.how == 'e' && (events[1].fd >= 0 || events[2].fd >= 0) &&
                 poll(events.data() + 1, 2, 0) > 0);
        if (!over && (cpu_time(child) > limits.cpu || std::chrono::steady_clock::now() - start > limits.wall))
            end.how = 't';
        if (end.how != 'e') {
            kill(child, SIGKILL);
            over = true;
        }
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (end.how != 'e') return end;
    if (WIFSIGNALED(status)) {
        // The kernel's own limit on time is the same limit.
        end.how = WTERMSIG(status) == SIGXCPU ? 't' : 's';
        end.detail = WTERMSIG(status);
    } else {
        end.detail = WEXITSTATUS(status);
        if (end.detail == not_started) end.how = 'f';
    }
    return end;
}

} // namespace

End run(const Run& what, const Limits& limits) {
    const Descriptor input = file_with(what.input);
    Pipe print = new_pipe(), answer = new_pipe();
    if (input.get() < 0 || print.out.get() < 0 || answer.out.get() < 0) return {'f', 0, {}, {}};
    const pid_t child = fork();
    if (child < 0) return {'f', 0, {}, {}};
    if (child == 0) become(what, limits, input.get(), print.in.get(), answer.in.get());
    print.in.shut();
    answer.in.shut();
    return watch(child, print, answer, limits);
}

void become_server(const std::string& program) {
    constexpr rlim_t server_seconds = 600;
    // What it prints goes nowhere: a file that it may not write to.
    std::signal(SIGXFSZ, SIG_IGN);
    const int nowhere = memfd_create("print", 0);
    if (dup2(STDOUT_FILENO, answers) < 0 || dup2(nowhere, STDOUT_FILENO) < 0 ||
        dup2(nowhere, STDERR_FILENO) < 0 || syscall(SYS_close_range, answers + 1, ~0U, 0) != 0)
        _exit(not_started);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, server_seconds);
    if (!set_limits()) _exit(not_started);
    start(program, {"serve"});
}

} // namespace rayscope::runner
