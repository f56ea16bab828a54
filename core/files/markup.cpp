#include "core/files/markup.hpp"

#include "core/files/utf8.hpp"

namespace rayscope {

std::string in_markup(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const std::string_view character = text.substr(0, length == 0 ? 1 : length);
        text.remove_prefix(character.size());
        const bool forbidden = character.size() == 1 && static_cast<unsigned char>(character[0]) < 0x20 &&
                               character != "\n" && character != "\t";
        if (length == 0 || forbidden || character == "\xEF\xBF\xBE" || character == "\xEF\xBF\xBF")
            result += "?";
        else if (character == "<")
            result += "&lt;";
        else if (character == ">")
            result += "&gt;";
        else if (character == "&")
            result += "&amp;";
        else if (character == "\"")
            result += "&quot;";
        else
            result += character;
    }
    return result;
}

} // namespace rayscope
