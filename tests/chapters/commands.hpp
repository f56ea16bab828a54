#pragma once
// The commands that a lesson tells its reader to type.

#include <string>
#include <vector>

namespace rayscope::test {

struct ShownCommand {
    int line = 0;
    std::string text; ///< what follows ./rayscope, without a comment: "step prism --quiz"

    [[nodiscard]] std::string name() const { return text.substr(0, text.find(' ')); }
    [[nodiscard]] bool has(const std::string& option) const;
};

/// Indented or fenced lines that begin with ./rayscope, and what stands so between backticks. What a page shows with its
/// output ("$ ./rayscope …") is compared elsewhere. `NAME` and `…` in a command stand for something else: left out.
[[nodiscard]] std::vector<ShownCommand> commands_of(const std::string& page);

enum class Effort {
    at_once,     ///< in a moment, by the terminal program alone
    long_or_vtk, ///< needs seconds, or the program that draws
    elsewhere,   ///< another program's, or a conversation: it is looked at, not run
};
[[nodiscard]] Effort effort_of(const ShownCommand& command);

/// The same, small: no picture where none is asked for, and images of a few pixels.
[[nodiscard]] std::string made_small(const ShownCommand& command);

} // namespace rayscope::test
