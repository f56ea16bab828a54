#pragma once
// Colours of the terminal: those of the pictures.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::cli {

/// Adds colour codes to text, or leaves it as it is.
class Paint {
public:
    explicit Paint(bool on) : on_(on) {}

    [[nodiscard]] std::string kind(RayKind kind, const std::string& text) const;
    [[nodiscard]] std::string bold(const std::string& text) const { return with("1", text); }
    [[nodiscard]] std::string dim(const std::string& text) const { return with("2", text); }

private:
    [[nodiscard]] std::string with(const char* code, const std::string& text) const {
        return on_ ? "\033[" + std::string(code) + "m" + text + "\033[0m" : text;
    }
    bool on_;
};

/// True if the file descriptor is a terminal that shows colours, and NO_COLOR is not set (no-color.org).
[[nodiscard]] bool wants_colours(int file_descriptor);

/// "eye", "reflected", …
[[nodiscard]] const char* name_of(RayKind kind);

} // namespace rayscope::cli
