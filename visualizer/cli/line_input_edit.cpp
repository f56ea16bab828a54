// Line input with libedit: arrow keys and history.

#include "visualizer/cli/line_input.hpp"

#include <editline/readline.h>

#include <cstdio>
#include <cstdlib>
#include <memory>

namespace rayscope::cli {

LineInput::LineInput() { using_history(); }

std::optional<std::string> LineInput::read(const std::string& prompt) {
    std::fflush(stdout);
    const std::unique_ptr<char, void (*)(void*)> line(readline(prompt.c_str()), &std::free);
    if (!line) return std::nullopt;
    if (*line.get() != '\0') add_history(line.get());
    return line.get();
}

} // namespace rayscope::cli
