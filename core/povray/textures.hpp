#pragma once
// Our materials as POV-Ray's textures.

#include "core/scene/scene.hpp"

#include <map>
#include <string>

namespace rayscope::povray {

/// The textures of a file: one for each pair of a material of an object and a material of a wall of it.
class Textures {
public:
    explicit Textures(const Scene& scene) : scene_(scene) {}

    /// "texture { Material_1 }", and "interior_texture { Inside_1 }" with it where light that leaves goes on through
    /// the wall. Declares them at the first use.
    /// @param object index of the material whose reflection and transmission count
    /// @param wall index of the material whose ambient, diffuse and specular light count
    [[nodiscard]] std::string use(std::size_t object, std::size_t wall, bool has_volume);

    /// The same for the wall of one solid, patterns in its own space with it where they can be shown.
    /// @param place the solid's object space → POV-Ray's space
    [[nodiscard]] std::string use(std::size_t object, std::size_t wall, bool has_volume, const Mat4d& place);

    /// Whether there are patterns, and POV-Ray can show them: of an opaque object, all with the same cells.
    [[nodiscard]] bool shows_patterns(std::size_t object, std::size_t wall) const;
    /// Whether there are patterns that can't be shown.
    [[nodiscard]] bool loses_patterns(std::size_t object, std::size_t wall) const;

    /// All declarations so far, each ended by a newline.
    [[nodiscard]] const std::string& declarations() const { return declarations_; }

private:
    [[nodiscard]] std::string patterned(std::size_t object, std::size_t wall, const Mat4d& place) const;

    const Scene& scene_;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers_;
    std::string declarations_;
};

} // namespace rayscope::povray
