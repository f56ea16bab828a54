#pragma once
// Text for a terminal.

#include <string>
#include <string_view>

namespace rayscope::exercises {

/// Colours, where stdout is a terminal and NO_COLOR is not set.
class Screen {
public:
    explicit Screen(bool colours) : colours_(colours) {}
    [[nodiscard]] static Screen of_stdout();

    [[nodiscard]] std::string bold(std::string_view text) const { return with("1", text); }
    [[nodiscard]] std::string dim(std::string_view text) const { return with("2", text); }
    [[nodiscard]] std::string good(std::string_view text) const { return with("32", text); }
    [[nodiscard]] std::string bad(std::string_view text) const { return with("31", text); }

private:
    [[nodiscard]] std::string with(const char* code, std::string_view text) const;
    bool colours_;
};

/// Words wrapped to 80 columns, every line indented.
[[nodiscard]] std::string wrapped(std::string_view text, std::size_t indent);

/// What a terminal would obey, or is no UTF-8, becomes '?'; line breaks stay.
[[nodiscard]] std::string harmless(std::string_view text);

/// "2.5", "10": points without needless digits.
[[nodiscard]] std::string points_text(double points);

/// How the launcher was called: "./rayscope".
[[nodiscard]] std::string launcher();

} // namespace rayscope::exercises
