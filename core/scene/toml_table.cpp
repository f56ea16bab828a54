#include "core/scene/toml_reader.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace rayscope {
namespace {

Place place(const toml::key& key) { return {int(key.source().begin.line), int(key.source().begin.column)}; }

bool is_name(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_'; };
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    return !text.empty() && letter(text.front()) &&
           std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || digit(c); });
}

// What other programs' scenes ask for, and no key of this one's.
std::string_view not_simulated(std::string_view key) {
    struct Word {
        std::string_view key, effect;
    };
    static constexpr Word words[] = {{"aperture", "depth of field"},
                                     {"focus", "depth of field"},
                                     {"focal_distance", "depth of field"},
                                     {"focal_length", "depth of field"},
                                     {"blur", "depth of field"},
                                     {"lens_radius", "depth of field"},
                                     {"motion", "motion"},
                                     {"motion_blur", "motion"},
                                     {"velocity", "motion"},
                                     {"shutter", "motion"},
                                     {"animation", "motion"},
                                     {"keyframes", "motion"},
                                     {"bump", "bump maps"},
                                     {"bump_map", "bump maps"},
                                     {"normal_map", "bump maps"},
                                     {"displacement", "bump maps"},
                                     {"texture", "image textures"},
                                     {"image", "image textures"},
                                     {"map", "image textures"},
                                     {"conductor", "conductors"},
                                     {"metal", "conductors"},
                                     {"metallic", "conductors"},
                                     {"extinction", "conductors"}};
    const auto found = std::ranges::find(words, key, &Word::key);
    return found == std::end(words) ? std::string_view() : found->effect;
}

} // namespace

void TomlTable::allow_only(std::string_view what, const std::vector<std::string_view>& keys) const {
    for (const TomlEntry& entry : entries()) {
        if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) continue;
        if (const auto effect = not_simulated(entry.key); !effect.empty())
            source_->fail(entry.place, fmt::format("{}: rayscope does not simulate {}; take the key away",
                                                   in_quotes(entry.key), effect));
        const std::string hint = did_you_mean(entry.key, keys);
        source_->fail(entry.place, fmt::format("{} has no key {}{}", what, in_quotes(entry.key),
                                               hint.empty() ? "; expected " + one_of(keys) : hint));
    }
}

void TomlTable::allow_one(std::string_view first, std::string_view second) const {
    if (!has(first) || !has(second)) return;
    const auto in_file = [](Place a, Place b) {
        return std::tie(a.line, a.column) < std::tie(b.line, b.column);
    };
    Place before = place_of(first), after = place_of(second);
    if (in_file(after, before)) {
        std::swap(before, after);
        std::swap(first, second);
    }
    source_->fail(after, fmt::format("'{}' and '{}' exclude each other, and line {} already gives '{}'",
                                     second, first, before.line, first));
}

std::optional<TomlValue> TomlTable::find(std::string_view key) const {
    const toml::node* node = table_->get(key);
    if (node == nullptr) return std::nullopt;
    return TomlValue(*source_, *node, std::string(key));
}

TomlValue TomlTable::require(std::string_view key, Place place, std::string_view example) const {
    auto value = find(key);
    if (!value)
        source_->fail(place,
                      fmt::format("{} needs {}, for example {}", in_quotes(name_), in_quotes(key), example));
    return *std::move(value);
}

std::vector<TomlEntry> TomlTable::entries() const {
    std::vector<TomlEntry> list;
    list.reserve(table_->size());
    for (const auto& [key, node] : *table_)
        list.push_back({key.str(), place(key), TomlValue(*source_, node, std::string(key.str()))});
    std::sort(list.begin(), list.end(), [](const TomlEntry& a, const TomlEntry& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    return list;
}

std::vector<TomlEntry> TomlTable::named_entries(std::string_view what) const {
    auto list = entries();
    for (const TomlEntry& entry : list)
        if (!is_name(entry.key))
            source_->fail(entry.place,
                          fmt::format("{} is no name for {}: expected a letter or _, then letters, "
                                      "digits or _",
                                      in_quotes(entry.key), what));
    return list;
}

Place TomlTable::place_of(std::string_view key) const {
    const auto found = table_->find(key);
    return found == table_->end() ? Place{} : place(found->first);
}

} // namespace rayscope
