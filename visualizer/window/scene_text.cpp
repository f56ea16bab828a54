// A scene's TOML text with other values in the places of the old ones.

#include "visualizer/window/scene_edit.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <array>

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

/// "section.name.key".
struct Path {
    std::array<std::string, 2> tables;
    std::string key;
};

Path path_of(const std::string& edit) {
    const auto first = edit.find('.'), last = edit.rfind('.');
    return {{edit.substr(0, first), edit.substr(first + 1, last - first - 1)}, edit.substr(last + 1)};
}

/// Speed and index are the same number, in two ways.
std::string in_place_of(const std::string& text, const std::string& key, const std::string& written) {
    return key == written ? text : toml_number(1 / std::stod(text));
}

struct Bytes {
    std::size_t begin, end;
};
Bytes bytes_of(const std::string& text, const toml::node& node) {
    return {offset_of(text, node.source().begin), offset_of(text, node.source().end)};
}

/// The numbers of a file's last transform, if it is a translation.
const toml::array* last_translation(const toml::array& steps) {
    const auto* step = steps.empty() ? nullptr : steps.back().as_table();
    return step == nullptr ? nullptr : step->get_as<toml::array>("translate");
}

/// A translation behind all other steps: joined with the last one if that is one, too.
std::string with_translation(std::string text, const toml::array& steps, const std::string& step) {
    const toml::table wanted = toml::parse("step = " + step);
    const toml::array& offset = *wanted["step"]["translate"].as_array();
    const auto* last = last_translation(steps);
    if (last == nullptr) {
        const std::size_t place =
            steps.empty() ? bytes_of(text, steps).begin + 1 : bytes_of(text, steps.back()).end;
        return text.insert(place, (steps.empty() ? "" : ", ") + step);
    }
    for (std::size_t i = offset.size(); i-- > 0;) { // from behind: the places before stay what they are
        const double by = offset[i].value_or(0.0);
        if (by == 0) continue;
        const Bytes place = bytes_of(text, (*last)[i]);
        text.replace(place.begin, place.end - place.begin, toml_number(tidy((*last)[i].value_or(0.0) + by)));
    }
    return text;
}

/// "name." of a line "name.key = " that ends where a value begins; empty if it is no such line.
std::string dotted_prefix(const std::string& text, std::size_t value) {
    const std::size_t line = text.rfind('\n', value) + 1; // npos + 1 is 0
    const std::string before = text.substr(line, value - line);
    const auto equals = before.find_last_not_of(" \t"), dot = before.rfind('.', equals);
    const bool is_line = equals != std::string::npos && before[equals] == '=' && dot != std::string::npos &&
                         before.find_first_of("{[,#") == std::string::npos;
    return is_line ? before.substr(0, dot + 1) : "";
}

/// Text that a table without a line of its own, which lines "name.key = value" make, holds one entry more.
std::string with_dotted_entry(const std::string& text, const toml::table& table, const std::string& entry) {
    Bytes last{0, 0};
    for (const auto& [key, node] : table)
        if (const Bytes place = bytes_of(text, node); place.end > last.end) last = place;
    const std::string prefix = dotted_prefix(text, last.begin);
    if (prefix.empty()) return {};
    const std::size_t line = std::min(text.find('\n', last.end), text.size());
    return text.substr(0, line) + "\n" + prefix + entry + text.substr(line);
}

/// Text that the table holds one entry more.
std::string with_entry(const std::string& text, const toml::table& table, const std::string& entry) {
    const auto [begin, end] = bytes_of(text, table);
    if (begin < text.size() && text[begin] == '[') { // "[head]"
        const std::size_t line = std::min(text.find('\n', begin), text.size());
        return text.substr(0, line) + "\n" + entry + text.substr(line);
    }
    if (begin < text.size() && text[begin] == '{') {
        const std::size_t last = text.find_last_not_of(" \t", end - 2) + 1;
        return text.substr(0, last) + (table.empty() ? "" : ", ") + entry + text.substr(last);
    }
    return with_dotted_entry(text, table, entry);
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
    if (const auto* steps = table->get_as<toml::array>("transform");
        steps != nullptr && path.key == "transform")
        return with_translation(text, *steps, value);
    for (const std::string& key : {path.key, std::string(path.key == "index" ? "speed" : path.key)})
        if (const toml::node* node = table->get(key)) {
            const auto [begin, end] = bytes_of(text, *node);
            return text.substr(0, begin) + in_place_of(value, path.key, key) + text.substr(end);
        }
    const std::string entry = path.key + " = " + (path.key == "transform" ? "[" + value + "]" : value);
    std::string longer = with_entry(text, *table, entry);
    if (longer.empty())
        throw InputError(file, {},
                         name + " is not in the file, and there is no line where it could be added");
    return longer;
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
