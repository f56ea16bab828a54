#pragma once
// The closed set of generic shapes, each at its place and size in object space.
// To add one: write its struct with the members that Sphere has, and name it here.

#include "core/generics/cube.hpp"
#include "core/generics/mesh.hpp"
#include "core/generics/open_tube.hpp"
#include "core/generics/plane.hpp"
#include "core/generics/polygon.hpp"
#include "core/generics/sphere.hpp"
#include "core/generics/torus.hpp"

#include <variant>

namespace rayscope {

template <Numbers N>
using Generic = std::variant<Sphere<N>, Plane<N>, Cylinder<N>, Cone<N>, Cube<N>, Torus<N>, Polygon<N>,
                             OpenCylinder<N>, OpenCone<N>, Mesh<N>>;

inline constexpr std::size_t generic_kinds = std::variant_size_v<Generic<double>>;

/// Generic::index() of a shape.
template <Numbers N, typename Shape, std::size_t from = 0>
[[nodiscard]] constexpr std::size_t generic_index() {
    if constexpr (std::is_same_v<Shape, std::variant_alternative_t<from, Generic<N>>>)
        return from;
    else
        return generic_index<N, Shape, from + 1>();
}

/// "sphere", "plane", …
template <Numbers N> [[nodiscard]] const char* generic_name(const Generic<N>& generic) {
    return std::visit([](const auto& shape) { return shape.name; }, generic);
}

/// The name of the kind with this Generic::index().
[[nodiscard]] const char* generic_name(std::size_t kind);

/// False for surfaces without volume, which can't be operands of a compound.
template <Numbers N> [[nodiscard]] bool is_solid(const Generic<N>& generic) {
    return std::visit([](const auto& shape) { return shape.solid; }, generic);
}

/// Negative inside, positive outside, zero on the surface, and near it about the distance: object space.
template <Numbers N>
[[nodiscard]] ScalarOf<N> implicit_value(const Generic<N>& generic, const Vec3<ScalarOf<N>>& p) {
    return std::visit([&](const auto& shape) { return shape.value(p); }, generic);
}

/// The shape as the author wrote it, for the kernels of other numbers.
template <Numbers N> [[nodiscard]] Generic<N> to_numbers(const Generic<double>& generic) {
    return std::visit([](const auto& shape) -> Generic<N> { return shape.template to<N>(); }, generic);
}

} // namespace rayscope
