#include "bench/support/child.hpp"

#include <array>

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayscope::bench {
namespace {

// @param out a file descriptor for both of its outputs, or −1
pid_t spawn(const std::vector<std::string>& words, int out) {
    std::vector<std::string> copies = words;
    std::vector<char*> arguments;
    for (std::string& word : copies) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    if (out >= 0) {
        posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
        posix_spawn_file_actions_adddup2(&actions, out, STDERR_FILENO);
    }
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return error == 0 ? child : -1;
}

} // namespace

std::filesystem::path program_folder() {
    std::error_code ignored;
    return std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path();
}

int run_child(const std::vector<std::string>& words) {
    const pid_t child = spawn(words, -1);
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) < 0 || !WIFEXITED(status)) return 127;
    return WEXITSTATUS(status);
}

std::string output_of(const std::vector<std::string>& words) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) return "";
    const pid_t child = spawn(words, ends[1]);
    close(ends[1]);
    std::string text;
    std::array<char, 4096> part;
    for (ssize_t count = 0; (count = ::read(ends[0], part.data(), part.size())) > 0;)
        text.append(part.data(), std::size_t(count));
    close(ends[0]);
    if (child < 0) return words[0] + ": can't be run\n";
    waitpid(child, nullptr, 0);
    return text;
}

} // namespace rayscope::bench
