#include "core/scene/nff_tube.hpp"

#include "core/math/decimals.hpp"
#include "core/math/transform.hpp"

#include <utility>

namespace rayscope {

std::optional<PlacedTube> place_tube(TubeEnd base, TubeEnd apex) {
    base.radius = magnitude(base.radius);
    apex.radius = magnitude(apex.radius);
    if (apex.radius > base.radius) std::swap(base, apex);
    const Vec3d axis = apex.centre - base.centre;
    if (length(axis) == 0 || base.radius == 0) return std::nullopt;

    const Vec3d w = normalized(axis), u = across(w), v = cross(w, u);
    const std::array<Vec3d, 4> columns{base.radius * u, base.radius * v, axis / 2.0,
                                       base.centre + axis / 2.0};
    PlacedTube tube;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) tube.matrix[column][row] = columns[std::size_t(column)][row];
    if (!is_invertible(tube.matrix)) return std::nullopt;

    const double top = apex.radius / base.radius;
    if (1 - top <= decimals::same_radius)
        tube.shape = OpenCylinder<double>{};
    else
        tube.shape = OpenCone<double>{top};
    return tube;
}

} // namespace rayscope
