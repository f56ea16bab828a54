#include "exercises/program/screen.hpp"

#include "core/files/utf8.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <sstream>

#include <unistd.h>

namespace rayscope::exercises {
namespace {

constexpr std::size_t page_width = 80;

std::size_t columns(std::string_view text) {
    std::size_t count = 0;
    for (const char c : text) count += continues_character(c) ? 0 : 1;
    return count;
}

} // namespace

Screen Screen::of_stdout() {
    return Screen(isatty(STDOUT_FILENO) != 0 && std::getenv("NO_COLOR") == nullptr);
}

std::string Screen::with(const char* code, std::string_view text) const {
    return colours_ ? fmt::format("\033[{}m{}\033[0m", code, text) : std::string(text);
}

std::string wrapped(std::string_view text, std::size_t indent) {
    const std::string margin(indent, ' ');
    std::istringstream words{std::string(text)};
    std::string result, line;
    for (std::string word; words >> word;) {
        if (!line.empty() && columns(line) + 1 + columns(word) + indent > page_width) {
            result += margin + line + "\n";
            line.clear();
        }
        line += (line.empty() ? "" : " ") + word;
    }
    return result + margin + line + "\n";
}

std::string harmless(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        const bool breaks = character == "\n" || character == "\t";
        const bool shown = length > 0 && (breaks || !steers_terminal(utf8_code_point(character)));
        result += shown ? character : "?";
        text.remove_prefix(character.size());
    }
    return result;
}

std::string points_text(double points) { return fmt::format("{:.6g}", points); }

std::string launcher() {
    const char* const name = std::getenv("RAYSCOPE_LAUNCHER");
    return name != nullptr ? name : "./rayscope";
}

} // namespace rayscope::exercises
