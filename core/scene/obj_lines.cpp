#include "core/scene/obj_lines.hpp"

#include <algorithm>
#include <string_view>

namespace rayscope {
namespace {

constexpr std::string_view mark = "\xEF\xBB\xBF";

bool is_data(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view keyword = line.substr(0, line.find_first_of(" \t"));
    return keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "f";
}

void blank_comments(std::string& text) {
    for (std::size_t comment = text.find('#'); comment != std::string::npos;
         comment = text.find('#', comment)) {
        const std::size_t begin = text.find_last_of("\r\n", comment) + 1; // 0 on the first line
        const std::size_t end = std::min(text.find_first_of("\r\n", comment), text.size());
        if (is_data(std::string_view(text).substr(begin, comment - begin)))
            std::fill(text.begin() + std::ptrdiff_t(comment), text.begin() + std::ptrdiff_t(end), ' ');
        comment = end;
    }
}

// A backslash at the end of any other line, of a name or of a comment, is a part of it.
std::string without_continuations(std::string_view text) {
    std::string joined;
    joined.reserve(text.size());
    bool data = false;
    std::size_t owed = 0; // ends of lines
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        std::string_view line = text.substr(0, end);
        const std::string_view line_end = text.substr(end, text.substr(end).starts_with("\r\n") ? 2 : 1);
        text.remove_prefix(end + line_end.size());
        if (owed == 0) data = is_data(line);
        if (data) line = line.substr(0, line.find('#'));
        if (data && line.ends_with('\\')) {
            joined.append(line.substr(0, line.size() - 1)) += ' ';
            ++owed;
            continue;
        }
        joined.append(line);
        for (++owed; owed > 0; --owed) joined.append(line_end);
    }
    return joined;
}

} // namespace

std::string tidied_obj(std::string text) {
    if (text.starts_with(mark)) std::fill_n(text.begin(), mark.size(), ' ');
    if (text.find("\\\n") != std::string::npos || text.find("\\\r") != std::string::npos)
        return without_continuations(text);
    blank_comments(text); // in place: most files have no continuations, and are large
    return text;
}

} // namespace rayscope
