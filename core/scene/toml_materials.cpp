#include "core/scene/toml_optics.hpp"
#include "core/scene/toml_sections.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

namespace rayscope {
namespace {

// Far beyond any medium, and close enough to 1 that ratios of two stay exact in their order.
constexpr Bounds possible_speed{1 / 1e6, 1e6};

/// The largest sum of reflection and transmission that a place of the surface can have, in any colour.
double most_light(const SceneMaterial& material) {
    const auto &mirrors = material.patterns.reflection, &passes = material.patterns.transmission;
    if (mirrors && passes && mirrors->has_cells_of(*passes))
        return maximum(largest_component(mirrors->even + passes->even),
                       largest_component(mirrors->odd + passes->odd));
    return largest_component(largest_of(material.reflection, mirrors) +
                             largest_of(material.transmission, passes));
}

SceneMaterial read_material(const TomlEntry& entry) {
    const TomlTable table = entry.value.table();
    std::vector<std::string_view> keys{"ambient",    "diffuse",      "specular", "shininess",
                                       "reflection", "transmission", "speed",    "index"};
    keys.insert(keys.end(), optic_keys.begin(), optic_keys.end());
    table.allow_only("a material", keys);
    SceneMaterial material;
    material.name = entry.key;
    material.place = entry.place;
    Patterns& patterns = material.patterns;
    const auto read = [&](std::string_view key, const Bounds& bounds, Colour& colour,
                          std::optional<Pattern>& pattern) {
        if (const auto value = table.find(key)) read_coefficient(*value, bounds, colour, pattern);
    };
    read("ambient", not_negative, material.ambient, patterns.ambient);
    read("diffuse", not_negative, material.diffuse, patterns.diffuse);
    read("specular", not_negative, material.specular, patterns.specular);
    read("reflection", from_0_to_1, material.reflection, patterns.reflection);
    read("transmission", from_0_to_1, material.transmission, patterns.transmission);
    if (const auto shininess = table.find("shininess")) material.shininess = shininess->number(not_negative);
    material.speed = read_speed(table).value_or(material.speed);
    read_optics(table, material);

    // 0.7 + 0.3 is no more than 1 for its author, whatever the last bit says.
    const double sum = most_light(material);
    if (sum > 1 + 4 * epsilon<double>)
        table.find("transmission")
            ->fail(
                fmt::format("reflection + transmission is {:.6g}, expected at most 1 in each colour", sum));
    return material;
}

} // namespace

std::size_t named(const SourceText& source, Place place, std::string_view name, std::string_view kind,
                  const NameIndex& index) {
    if (const auto found = index.find(name); found != index.end()) return found->second;
    std::vector<std::string_view> names;
    names.reserve(index.size());
    for (const auto& known : index) names.push_back(known.first);
    source.fail(place, fmt::format("unknown {} {}{}", kind, in_quotes(name), did_you_mean(name, names)));
}

std::size_t named(const TomlValue& value, std::string_view kind, const NameIndex& index) {
    return named(value.source(), value.place(), value.string(), kind, index);
}

std::optional<double> read_speed(const TomlTable& table) {
    table.allow_one("speed", "index");
    if (const auto speed = table.find("speed")) return speed->number(possible_speed);
    if (const auto index = table.find("index")) return 1 / index->number(possible_speed);
    return std::nullopt;
}

NameIndex read_materials(const TomlTable& root, Scene& scene) {
    NameIndex index;
    if (const auto section = root.find("materials"))
        for (const TomlEntry& entry : section->table().named_entries("a material")) {
            index.emplace(entry.key, scene.materials.size());
            scene.materials.push_back(read_material(entry));
        }
    return index;
}

} // namespace rayscope
