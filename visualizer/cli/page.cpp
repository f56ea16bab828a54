#include "visualizer/cli/page.hpp"

#include <algorithm>
#include <vector>

namespace rayscope::cli {
namespace {

constexpr std::size_t label_end = 15; // where the texts of items begin

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
    std::vector<std::string_view> parts;
    for (std::size_t at = text.find(separator); at != std::string_view::npos; at = text.find(separator)) {
        parts.push_back(text.substr(0, at));
        text.remove_prefix(at + separator.size());
    }
    parts.push_back(text);
    return parts;
}

std::string with_blanks(std::string_view text) {
    std::string result;
    for (const std::string_view part : split(text, glue))
        result += (result.empty() ? "" : " ") + std::string(part);
    return result;
}

/// Words to be set one after the other; one that is too long for a whole line is taken apart at its glue.
std::vector<std::string_view> words_of(std::string_view text, std::size_t room) {
    std::vector<std::string_view> words;
    for (const std::string_view word : split(text, " ")) {
        if (columns(word) <= room)
            words.push_back(word);
        else
            for (const std::string_view part : split(word, glue)) words.push_back(part);
    }
    return words;
}

} // namespace

std::size_t columns(std::string_view text) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\033') {
            while (i < text.size() && text[i] != 'm') ++i;
            continue;
        }
        const bool continues = (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80;
        if (!continues) ++count;
    }
    return count;
}

std::string harmless(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        if (length == 0 || steers_terminal(utf8_code_point(character)))
            result += '?';
        else
            result += character;
        text.remove_prefix(character.size());
    }
    return result;
}

std::string harmless_lines(std::string_view text) {
    std::string result;
    for (const std::string_view line : split(text, "\n"))
        result += (result.empty() ? "" : "\n") + harmless(line);
    return result;
}

void Page::rule(const std::string& text) {
    std::string rest;
    for (std::size_t i = columns(text) + 4; i < page_width; ++i) rest += "─";
    text_ += "\n" + paint_.dim("──") + " " + text + " " + paint_.dim(rest) + "\n";
}

void Page::heading(const std::string& text) { text_ += "\n" + paint_.bold(text) + "\n"; }

void Page::item(const std::string& label, const std::string& text, std::size_t level) {
    const std::string start = std::string(2 + 2 * level, ' ') + label;
    const std::size_t used = columns(start);
    const std::string hanging(label_end, ' ');
    line(used < label_end ? start + std::string(label_end - used, ' ') : start + "  ", hanging, text);
}

void Page::line(const std::string& text, std::size_t indent) {
    line(std::string(indent, ' '), std::string(indent, ' '), text);
}

void Page::line(const std::string& first, const std::string& next, const std::string& text) {
    std::size_t at = columns(first);
    const std::size_t indent = columns(next);
    text_ += first;
    bool empty = true;
    for (const std::string_view word : words_of(text, indent < page_width ? page_width - indent : 1)) {
        const std::size_t width = columns(word);
        if (!empty && at + 1 + width > page_width) {
            text_ += "\n" + next;
            at = indent;
            empty = true;
        }
        if (!empty) text_ += ' ';
        text_ += with_blanks(word);
        at += width + (empty ? 0 : 1);
        empty = false;
    }
    text_ += '\n';
}

} // namespace rayscope::cli
