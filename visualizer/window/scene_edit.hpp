#pragma once
// Numbers of a scene that the window changes: in the scene, and in the text of its file.

#include "core/rayscope.hpp"

#include <map>
#include <string>

namespace rayscope::window {

/// "materials.glass.reflection", and the value as TOML writes it: "0.12" or "[0.1, 0.2, 0.3]". Of
/// "generics.ball.transform" it is the step to go behind those in the file: "{translate = [0.1, 0, 0]}".
using Edits = std::map<std::string, std::string>;

/// The coefficients and numbers of a material that have a slider.
enum class MaterialPart : std::uint8_t {
    ambient,
    diffuse,
    specular,
    reflection,
    transmission,
    shininess,
    index
};
inline constexpr std::array<std::string_view, 7> part_names{
    "ambient", "diffuse", "specular", "reflection", "transmission", "shininess", "index"};

/// As one number: of a colour its largest component.
[[nodiscard]] double part_of(const SceneMaterial& material, MaterialPart part);
/// What a slider can go to, whatever the other numbers are.
[[nodiscard]] double range_of(MaterialPart part);
/// The largest that it may be: reflection and transmission share 1.
[[nodiscard]] double most_of(const SceneMaterial& material, MaterialPart part);
/// A pattern of two colours has no one number.
[[nodiscard]] bool is_patterned(const SceneMaterial& material, MaterialPart part);

/// Changes it; a colour keeps its hue. Returns the value as TOML writes it.
std::string set_part(SceneMaterial& material, MaterialPart part, double value);

/// A number as short as it can be without being another one.
[[nodiscard]] std::string toml_number(double number);
[[nodiscard]] std::string toml_vector(const Vec3d& v);

/// To the decimals that a step of this length can tell apart.
[[nodiscard]] Vec3d rounded(const Vec3d& v, double step);
/// A sum of decimals, without what rounding put into its last digits.
[[nodiscard]] double tidy(double sum);

/// The text with other values, all else, comments and order too, as it was. A value that is not there yet goes below
/// its table's head, or to the end of an inline table. Throws InputError where a value has no place in the text.
/// @param file for messages
[[nodiscard]] std::string with_edits(const std::string& file, std::string text, const Edits& edits);

} // namespace rayscope::window
