// A scene's TOML text with other values in the places of the old ones.

#include "visualizer/window/scene_edit.hpp"

#include <toml++/toml.h>

#include <algorithm>

namespace rayscope::window {
namespace {

/// Bytes from a place that the TOML library counts in lines and characters.
std::size_t offset_of(const std::string& text, const toml::source_position& place) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < place.line; ++line) {
        at = text.find('\n', at);
        if (at == std::string::npos) return text.size();
        ++at;
    }
    for (toml::source_index column = 1; column < place.column && at < text.size(); ++column)
        at += std::max<std::size_t>(utf8_length(std::string_view(text).substr(at)), 1);
    return std::min(at, text.size());
}

struct Path {
    std::vector<std::string> tables;
    std::string key;
};

Path path_of(const std::string& dotted) {
    Path path;
    std::size_t at = 0;
    for (auto dot = dotted.find('.'); dot != std::string::npos; dot = dotted.find('.', at)) {
        path.tables.push_back(dotted.substr(at, dot - at));
        at = dot + 1;
    }
    path.key = dotted.substr(at);
    return path;
}

/// Speed and index are the same number, in two ways.
std::string in_place_of(const std::string& text, const std::string& key, const std::string& written) {
    return key == written ? text : toml_number(1 / std::stod(text));
}

/// The end of the line with a table's "[head]".
std::size_t below_head(const std::string& text, const toml::table& table) {
    const std::size_t begin = offset_of(text, table.source().begin);
    if (begin >= text.size() || text[begin] != '[') return std::string::npos;
    const std::size_t end = text.find('\n', begin);
    return end == std::string::npos ? text.size() : end;
}

std::string with_edit(const std::string& file, const std::string& text, const std::string& name,
                      const std::string& value) {
    const toml::table root = toml::parse(text, file);
    const Path path = path_of(name);
    const toml::table* table = &root;
    for (const std::string& part : path.tables) {
        table = table->get_as<toml::table>(part);
        if (table == nullptr) throw InputError(file, {}, "has no table for " + name + ": it can't be saved");
    }
    for (const std::string& key : {path.key, std::string(path.key == "index" ? "speed" : path.key)})
        if (const toml::node* node = table->get(key)) {
            const std::size_t begin = offset_of(text, node->source().begin),
                              end = offset_of(text, node->source().end);
            return text.substr(0, begin) + in_place_of(value, path.key, key) + text.substr(end);
        }
    const std::size_t place = below_head(text, *table);
    if (place == std::string::npos)
        throw InputError(file, {}, name + " is not in the file, and its table has no line of its own");
    return text.substr(0, place) + "\n" + path.key + " = " + value + text.substr(place);
}

} // namespace

std::string with_edits(const std::string& file, std::string text, const Edits& edits) {
    try {
        // Each changes the places of what follows: the text is read anew for each.
        for (const auto& [name, value] : edits) text = with_edit(file, text, name, value);
        (void)toml::parse(text, file);
    } catch (const toml::parse_error& error) {
        throw InputError(file, {}, "can't be saved: " + std::string(error.description()));
    }
    return text;
}

} // namespace rayscope::window
