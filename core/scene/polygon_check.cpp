#include "core/scene/polygon_check.hpp"

#include "core/generics/polygon.hpp"
#include "core/math/decimals.hpp"

#include <fmt/format.h>

namespace rayscope {

std::optional<std::string> polygon_problem(const std::vector<Vec3d>& vertices, double flatness) {
    if (vertices.size() < 3)
        return fmt::format("a polygon needs at least 3 vertices, found {}", vertices.size());
    double size = 0;
    for (const Vec3d& vertex : vertices) size = maximum(size, length(vertex - vertices[0]));
    if (size == 0) return "the vertices of the polygon are one point";
    // Its area, a square, must stay a normal number.
    if (size < 1e-100 || size > 1e100) return "the polygon's size is not between 1e-100 and 1e100";

    // Measured in its own size, the test is the same for a crystal and for a planet.
    std::vector<Vec3d> shape;
    shape.reserve(vertices.size());
    for (const Vec3d& vertex : vertices) shape.push_back((vertex - vertices[0]) / size);
    const Vec3d area = area_vector(shape);
    if (length(area) < decimals::least_area)
        return "the polygon encloses no area: its vertices lie on one line, or it crosses itself";
    const Vec3d normal = normalized(area);
    for (std::size_t i = 0; i < shape.size(); ++i)
        if (const double off = magnitude(dot(normal, shape[i])); off > flatness)
            return fmt::format("the polygon is not flat: vertex {} lies {:.3g} off the plane of the others",
                               i + 1, off * size);
    return std::nullopt;
}

} // namespace rayscope
