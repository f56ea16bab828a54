#pragma once
// The parts of a TOML scene, each read by a function of its own. read_toml puts them together.

#include "core/scene/scene.hpp"
#include "core/scene/toml_reader.hpp"

#include <map>

namespace rayscope {

/// Names of one kind and where they stand in the scene's list; ordered, so that hints don't depend on chance.
using NameIndex = std::map<std::string_view, std::size_t>;

/// What `value` names, or an error with the nearest name. `kind`: "material".
[[nodiscard]] std::size_t named(const TomlValue& value, std::string_view kind, const NameIndex& index);

/// The same for a name that is part of a longer value. Fails at `place`.
[[nodiscard]] std::size_t named(const SourceText& source, Place place, std::string_view name,
                                std::string_view kind, const NameIndex& index);

/// A speed of light, given by 'speed' or by 'index' (of refraction), never both.
[[nodiscard]] std::optional<double> read_speed(const TomlTable& table);

/// The first step of the list is applied first. Always invertible.
[[nodiscard]] Mat4d read_transform(const TomlValue& value);

inline constexpr int largest_priority = 1000000;

/// What is settled only once it is known which solids are operands: whether they are drawn by themselves.
struct Visibility {
    std::vector<std::optional<bool>> generics, compounds; ///< as written, if it is
    std::vector<bool> generic_operands, compound_operands;
};

void read_camera(const TomlTable& root, Scene& scene);
void read_lights(const TomlTable& root, Scene& scene);
void read_settings(const TomlTable& root, Scene& scene); ///< [scene], [limits], [step]
[[nodiscard]] NameIndex read_materials(const TomlTable& root, Scene& scene);
[[nodiscard]] NameIndex read_generics(const TomlTable& root, const NameIndex& materials, Scene& scene,
                                      Visibility& visibility);
/// `source` is that of root; asked for places within strings.
void read_compounds(SourceText& source, const TomlTable& root, const NameIndex& materials,
                    const NameIndex& generics, Scene& scene, Visibility& visibility);

/// Fails at the first compound that, through others, is an operand of itself, and names the circle.
void reject_cycles(const SourceText& source, const Scene& scene);

} // namespace rayscope
