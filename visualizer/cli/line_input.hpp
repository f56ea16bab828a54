#pragma once
// A line that a person types: edited, completed and remembered where the library for it is there.

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace rayscope::cli {

/// Whole words that could stand in place of the last one of a line.
using Completer = std::function<std::vector<std::string>(const std::string& line)>;

class LineInput {
public:
    explicit LineInput(Completer completer);

    /// Nothing at the end of input.
    [[nodiscard]] std::optional<std::string> read(const std::string& prompt);
};

} // namespace rayscope::cli
