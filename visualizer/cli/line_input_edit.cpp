// Line input with libedit: arrow keys, history, completion.

#include "visualizer/cli/line_input.hpp"

#include <editline/readline.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace rayscope::cli {
namespace {

Completer completer; // the library asks functions, not objects

char* candidate(const char* /*word*/, int number) {
    static std::vector<std::string> found;
    if (number == 0) found = completer(std::string(rl_line_buffer).substr(0, std::size_t(rl_point)));
    const auto at = std::size_t(number);
    return at < found.size() ? strdup(found[at].c_str()) : nullptr;
}

/// Nothing of ours: then the library looks for files.
char** candidates(const char* word, int /*start*/, int /*end*/) {
    return rl_completion_matches(word, candidate);
}

} // namespace

LineInput::LineInput(Completer ours) {
    completer = std::move(ours);
    using_history();
    rl_attempted_completion_function = candidates;
}

std::optional<std::string> LineInput::read(const std::string& prompt) {
    std::fflush(stdout);
    const std::unique_ptr<char, void (*)(void*)> line(readline(prompt.c_str()), &std::free);
    if (!line) return std::nullopt;
    if (*line.get() != '\0') add_history(line.get());
    return line.get();
}

} // namespace rayscope::cli
