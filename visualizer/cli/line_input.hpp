#pragma once
// A line that a person types, edited and remembered where the library for it is there.

#include <optional>
#include <string>

namespace rayscope::cli {

class LineInput {
public:
    LineInput();

    /// Nothing at the end of input.
    [[nodiscard]] std::optional<std::string> read(const std::string& prompt);
};

} // namespace rayscope::cli
