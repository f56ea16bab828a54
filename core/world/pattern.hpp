#pragma once
// Coefficients that change over a surface.

#include "core/math/vec.hpp"

#include <optional>

namespace rayscope {

/// Two values that take turns in the object's own space: in cubes (checker) or in layers across one axis (stripes).
struct Pattern {
    enum class Kind : std::uint8_t { checker, stripes };

    Kind kind = Kind::checker;
    Colour even{0}, odd{1};
    double size = 1; ///< edge of a cube, thickness of a layer
    int axis = 0;    ///< of stripes: x, y or z

    /// Whether the other one's colours change where this one's do.
    [[nodiscard]] bool has_cells_of(const Pattern& other) const {
        return kind == other.kind && size == other.size && (kind == Kind::checker || axis == other.axis);
    }
    [[nodiscard]] const Colour& at(const Vec3d& point) const {
        const auto cell = [&](int i) { return std::floor(point[i] / size); };
        const double sum = kind == Kind::stripes ? cell(axis) : cell(0) + cell(1) + cell(2);
        return sum - 2 * std::floor(sum / 2) == 0 ? even : odd;
    }
};

/// The largest that a coefficient is anywhere, per colour.
[[nodiscard]] inline Colour largest_of(const Colour& colour, const std::optional<Pattern>& pattern) {
    return pattern ? maximum_of(pattern->even, pattern->odd) : colour;
}

/// Those of one material; a coefficient without one is the same everywhere.
struct Patterns {
    std::optional<Pattern> ambient, diffuse, specular, reflection, transmission;

    [[nodiscard]] bool any() const { return ambient || diffuse || specular || reflection || transmission; }
};

} // namespace rayscope
