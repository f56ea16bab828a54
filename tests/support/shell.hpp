#pragma once
// What a program prints where it is typed into a shell.

#include <array>
#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace rayscope::test {

struct Printed {
    int code = -1;
    std::string text; ///< both streams
};

/// A line for a shell; its programs read nothing.
[[nodiscard]] inline Printed printed_by_shell(const std::string& line) {
    FILE* const pipe = popen((line + " 2>&1 </dev/null").c_str(), "r");
    if (pipe == nullptr) return {-1, "could not run " + line};
    Printed printed;
    std::array<char, 4096> bytes{};
    while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), pipe))
        printed.text.append(bytes.data(), count);
    const int status = pclose(pipe);
    printed.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
    return printed;
}

} // namespace rayscope::test
