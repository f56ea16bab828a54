#include "core/scene/toml_reader.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

std::string_view type_name(const toml::node& node) {
    switch (node.type()) {
    case toml::node_type::table: return "a table";
    case toml::node_type::array: return "a list";
    case toml::node_type::string: return "a string";
    case toml::node_type::integer: return "an integer";
    case toml::node_type::floating_point: return "a number with a fraction";
    case toml::node_type::boolean: return "true or false";
    default: return "a date or time";
    }
}

std::string wording(const Bounds& bounds) {
    const bool below = bounds.min > -largest_number, above = bounds.max < largest_number;
    if (below && above && bounds.open)
        return fmt::format("a number between {} and {}", bounds.min, bounds.max);
    if (below && above) return fmt::format("a number from {} to {}", bounds.min, bounds.max);
    if (below) return fmt::format("a number from {} to 1e150", bounds.min);
    return "a number of at most 1e150 in size";
}

bool within(double x, const Bounds& bounds) {
    return bounds.open ? bounds.min < x && x < bounds.max : bounds.min <= x && x <= bounds.max;
}

} // namespace

Place TomlValue::place() const {
    const auto& begin = node_->source().begin;
    return {int(begin.line), int(begin.column)};
}

void TomlValue::fail_type(std::string_view expected) const {
    fail(fmt::format("'{}': expected {}, found {}", name_, expected, type_name(*node_)));
}

double TomlValue::number(const Bounds& bounds) const {
    if (!node_->is_number()) fail_type(wording(bounds));
    // Not the library's own conversion: it refuses integers that a double rounds.
    const double x = node_->is_integer() ? double(**node_->as_integer()) : **node_->as_floating_point();
    if (!within(x, bounds)) fail(fmt::format("'{}': expected {}, found {}", name_, wording(bounds), x));
    return x;
}

int TomlValue::integer(int min, int max) const {
    const auto expected = [&] { return fmt::format("an integer from {} to {}", min, max); };
    if (!node_->is_integer()) fail_type(expected());
    const auto x = **node_->as_integer();
    if (x < min || x > max) fail(fmt::format("'{}': expected {}, found {}", name_, expected(), x));
    return int(x);
}

bool TomlValue::boolean() const {
    if (!node_->is_boolean()) fail_type("true or false");
    return **node_->as_boolean();
}

std::string_view TomlValue::string() const {
    if (!node_->is_string()) fail_type("a string");
    return **node_->as_string();
}

std::vector<TomlValue> TomlValue::list() const {
    if (!node_->is_array()) fail_type("a list");
    std::vector<TomlValue> values;
    values.reserve(node_->as_array()->size());
    for (const toml::node& node : *node_->as_array()) values.emplace_back(*source_, node, name_);
    return values;
}

std::vector<TomlValue> TomlValue::list(std::size_t size, std::string_view shape) const {
    if (!node_->is_array()) fail_type(shape);
    auto values = list();
    if (values.size() != size)
        fail(fmt::format("'{}': expected {}, found {} value{}", name_, shape, values.size(),
                         values.size() == 1 ? "" : "s"));
    return values;
}

Vec3d TomlValue::vector() const {
    const auto parts = list(3, "[x, y, z]");
    return {parts[0].number(), parts[1].number(), parts[2].number()};
}

Colour TomlValue::colour(const Bounds& bounds) const {
    if (is_number()) return Colour{number(bounds)};
    const auto parts = list(3, "a number or [red, green, blue]");
    return {parts[0].number(bounds), parts[1].number(bounds), parts[2].number(bounds)};
}

TomlTable TomlValue::table() const {
    if (!node_->is_table()) fail_type("a table");
    return {*source_, *node_->as_table(), name_};
}

std::size_t TomlValue::choice(const std::vector<std::string_view>& choices) const {
    const auto found = std::find(choices.begin(), choices.end(), string());
    if (found == choices.end())
        fail(fmt::format("'{}': expected {}, found {}{}", name_, one_of(choices), in_quotes(string()),
                         did_you_mean(string(), choices)));
    return std::size_t(found - choices.begin());
}

} // namespace rayscope
