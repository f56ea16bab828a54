#pragma once
// Lines of text for a terminal of 80 columns.

#include "visualizer/cli/paint.hpp"

#include <string>
#include <string_view>

namespace rayscope::cli {

inline constexpr std::size_t page_width = 80;

/// No-break space: lines break there only where nothing else fits. Written out as a blank.
inline constexpr const char* glue = "\u00A0";

/// Columns that the text takes: characters, without colours. Control characters count, wide ones count once.
[[nodiscard]] std::size_t columns(std::string_view text);

/// Of a text from outside: what a terminal would obey, and what is no UTF-8, becomes '?'.
[[nodiscard]] std::string harmless(std::string_view text);
/// The same line by line.
[[nodiscard]] std::string harmless_lines(std::string_view text);

/// A page that grows downwards. Each text given is wrapped, and its further lines are indented to where it began.
class Page {
public:
    explicit Page(const Paint& paint) : paint_(paint) {}

    /// "── text ─────…" after an empty line.
    void rule(const std::string& text);
    /// A bold line after an empty one.
    void heading(const std::string& text);
    /// "  label        text", the text in a column of its own; `level` indents the label.
    void item(const std::string& label, const std::string& text, std::size_t level = 0);
    /// The text after so many blanks.
    void line(const std::string& text, std::size_t indent = 0);
    /// Wrapped text after a given beginning: its further lines start with `next`.
    void line(const std::string& first, const std::string& next, const std::string& text);
    void gap() { text_ += '\n'; }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    const Paint& paint_;
    std::string text_;
};

} // namespace rayscope::cli
