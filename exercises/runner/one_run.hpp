#pragma once
// One run of a program that nobody trusts: its words and input go in, how it ended and what it wrote come out.

#include "exercises/runner/time_limits.hpp"

#include <string>
#include <vector>

namespace rayscope::runner {

struct Limits {
    std::chrono::milliseconds cpu = most_computing, wall = most_waiting;
    bool computing_only =
        true; ///< false for programs with sanitizers, which need more than untrusted code gets
};

struct Run {
    std::string program; ///< its path
    std::vector<std::string> words;
    std::string input;
};

struct End {
    char how =
        'e'; ///< 'e' exited, 's' killed by a signal, 't' out of time, 'o' wrote too much, 'f' not started
    int detail = 0; ///< exit code, signal
    std::string printed,
        answer; ///< the beginning of what it wrote to stdout and stderr; all that it wrote to 3
};

[[nodiscard]] End run(const Run& what, const Limits& limits);

/// Becomes the program: it serves calls from this process's stdin, and answers where its stdout was. Never returns.
[[noreturn]] void become_server(const std::string& program);

} // namespace rayscope::runner
