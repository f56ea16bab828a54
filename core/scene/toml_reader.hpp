#pragma once
// Typed access to a TOML document: whatever is wrong throws one InputError at the place where it is written.

#include "core/math/vec.hpp"
#include "core/scene/source_text.hpp"

#include <toml++/toml.h>

#include <optional>
#include <string_view>
#include <vector>

namespace rayscope {

/// The numbers that a value may be.
struct Bounds {
    double min = 0, max = 0;
    bool open = false; ///< the ends themselves are excluded
};

/// Beyond this, products of a few numbers would leave the range of a double.
inline constexpr double largest_number = 1e150;
inline constexpr Bounds any_number{-largest_number, largest_number};
inline constexpr Bounds not_negative{0, largest_number};
inline constexpr Bounds from_0_to_1{0, 1};

class TomlTable;

/// One value, with the name by which messages call it.
class TomlValue {
public:
    TomlValue(const SourceText& source, const toml::node& node, std::string name)
        : source_(&source), node_(&node), name_(std::move(name)) {}

    [[nodiscard]] double number(const Bounds& bounds = any_number) const;
    [[nodiscard]] int integer(int min, int max) const;
    [[nodiscard]] bool boolean() const;
    [[nodiscard]] std::string_view string() const;
    /// [x, y, z]
    [[nodiscard]] Vec3d vector() const;
    /// [red, green, blue], or one number for all three
    [[nodiscard]] Colour colour(const Bounds& bounds) const;
    [[nodiscard]] std::vector<TomlValue> list() const;
    /// A list of exactly `size` values; `shape` says what they are: "[x, y, z]".
    [[nodiscard]] std::vector<TomlValue> list(std::size_t size, std::string_view shape) const;
    [[nodiscard]] TomlTable table() const;
    /// One of the choices: its index.
    [[nodiscard]] std::size_t choice(const std::vector<std::string_view>& choices) const;

    [[nodiscard]] bool is_number() const { return node_->is_number(); }
    [[nodiscard]] bool is_string() const { return node_->is_string(); }
    [[nodiscard]] bool is_table() const { return node_->is_table(); }
    [[nodiscard]] Place place() const;
    [[nodiscard]] const SourceText& source() const { return *source_; }
    [[noreturn]] void fail(const std::string& message) const { source_->fail(place(), message); }

private:
    [[noreturn]] void fail_type(std::string_view expected) const;

    const SourceText* source_;
    const toml::node* node_;
    std::string name_;
};

/// A key and its value.
struct TomlEntry {
    std::string_view key;
    Place place; ///< of the key
    TomlValue value;
};

class TomlTable {
public:
    TomlTable(const SourceText& source, const toml::table& table, std::string name)
        : source_(&source), table_(&table), name_(std::move(name)) {}

    /// Fails at the first key that is none of these. `what` is the kind of table: "a material".
    void allow_only(std::string_view what, const std::vector<std::string_view>& keys) const;
    /// Fails at the second of two keys that exclude each other, naming the line of the first.
    void allow_one(std::string_view first, std::string_view second) const;

    [[nodiscard]] std::optional<TomlValue> find(std::string_view key) const;
    [[nodiscard]] bool has(std::string_view key) const { return table_->contains(key); }
    /// Fails at `place` if the key is missing; `example` shows what could stand there.
    [[nodiscard]] TomlValue require(std::string_view key, Place place, std::string_view example) const;
    /// All keys in the order of the file, which the library's own order by name loses.
    [[nodiscard]] std::vector<TomlEntry> entries() const;
    /// The same, where each key is a name that the author chose: [A-Za-z_][A-Za-z0-9_]*.
    [[nodiscard]] std::vector<TomlEntry> named_entries(std::string_view what) const;

    [[nodiscard]] Place place_of(std::string_view key) const;
    [[nodiscard]] const SourceText& source() const { return *source_; }

private:
    const SourceText* source_;
    const toml::table* table_;
    std::string name_;
};

} // namespace rayscope
