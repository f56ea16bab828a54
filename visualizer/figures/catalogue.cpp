#include "visualizer/figures/catalogue.hpp"

#include "visualizer/figures/figures.hpp"

#include <toml++/toml.h>

#include <algorithm>

namespace rayscope::figures {
namespace {

std::string word(const std::filesystem::path& path, const toml::table& table, const std::string& name,
                 const char* key) {
    const auto value = table[key].value<std::string>();
    if (!value || value->empty())
        throw InputError(path.string(),
                         Place{int(table.source().begin.line), int(table.source().begin.column)},
                         "figure '" + name + "': expected a text '" + key + "'");
    return *value;
}

} // namespace

std::vector<Entry> read_catalogue() {
    const std::filesystem::path path = RAYSCOPE_SOURCE_DIR "/visualizer/figures/figures.toml";
    toml::table file;
    try {
        file = toml::parse_file(path.string());
    } catch (const toml::parse_error& error) {
        throw InputError(path.string(),
                         Place{int(error.source().begin.line), int(error.source().begin.column)},
                         std::string(error.description()));
    }
    std::vector<std::pair<int, Entry>> entries;
    for (const auto& [key, value] : file) {
        const std::string name(key.str());
        const toml::table* table = value.as_table();
        if (table == nullptr || drawer_of(name) == nullptr)
            throw InputError(path.string(), Place{int(value.source().begin.line), 1},
                             "no figure is called '" + name + "'");
        const auto text = [&](const char* wanted) { return word(path, *table, name, wanted); };
        entries.emplace_back(int(value.source().begin.line),
                             Entry{name, text("chapter"), text("scene"), text("title"), text("alt"),
                                   text("caption"), text("command")});
    }
    std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<Entry> list;
    for (auto& [line, entry] : entries) list.push_back(std::move(entry));
    return list;
}

std::string drawn(const Entry& entry, const std::filesystem::path& chapters) {
    const Subject subject{open(chapters / (entry.scene + ".toml")), chapters};
    return drawer_of(entry.name)(subject).finish(entry.title, entry.alt);
}

} // namespace rayscope::figures
