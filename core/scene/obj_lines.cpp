#include "core/scene/obj_lines.hpp"

#include <algorithm>
#include <string_view>

namespace rayscope {
namespace {

constexpr std::string_view mark = "\xEF\xBB\xBF";

bool may_have_comment(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    const std::string_view keyword = line.substr(0, line.find_first_of(" \t"));
    return keyword == "v" || keyword == "vt" || keyword == "vn" || keyword == "f";
}

void blank_comments(std::string& text) {
    for (std::size_t comment = text.find('#'); comment != std::string::npos;
         comment = text.find('#', comment)) {
        const std::size_t begin = text.find_last_of("\r\n", comment) + 1; // 0 on the first line
        const std::size_t end = std::min(text.find_first_of("\r\n", comment), text.size());
        if (may_have_comment(std::string_view(text).substr(begin, comment - begin)))
            std::fill(text.begin() + std::ptrdiff_t(comment), text.begin() + std::ptrdiff_t(end), ' ');
        comment = end;
    }
}

std::string without_continuations(const std::string& text) {
    std::string joined;
    joined.reserve(text.size());
    int owed = 0; // ends of lines
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::size_t end = text.compare(i, 3, "\\\r\n") == 0                                    ? 3
                                : text.compare(i, 2, "\\\n") == 0 || text.compare(i, 2, "\\\r") == 0 ? 2
                                                                                                     : 0;
        if (end > 0) {
            joined += ' ';
            ++owed;
            i += end - 1;
            continue;
        }
        joined += text[i];
        if (text[i] == '\n') {
            joined.append(std::size_t(owed), '\n');
            owed = 0;
        }
    }
    return joined;
}

} // namespace

std::string tidied_obj(std::string text) {
    if (text.starts_with(mark)) std::fill_n(text.begin(), mark.size(), ' ');
    const bool continues = text.find("\\\n") != std::string::npos || text.find("\\\r") != std::string::npos;
    if (continues) text = without_continuations(text);
    blank_comments(text);
    return text;
}

} // namespace rayscope
