// Line input without a library: what the terminal itself can edit.

#include "visualizer/cli/line_input.hpp"

#include <cstdio>
#include <iostream>

namespace rayscope::cli {

LineInput::LineInput(Completer) {}

std::optional<std::string> LineInput::read(const std::string& prompt) {
    std::fputs(prompt.c_str(), stdout);
    std::fflush(stdout);
    std::string line;
    if (!std::getline(std::cin, line)) return std::nullopt;
    return line;
}

} // namespace rayscope::cli
