#pragma once
// The closed set of generic shapes, each at its place and size in object space.
// To add one: write its struct with the members that Sphere has, and name it here.

#include "core/generics/cube.hpp"
#include "core/generics/open_tube.hpp"
#include "core/generics/plane.hpp"
#include "core/generics/polygon.hpp"
#include "core/generics/sphere.hpp"
#include "core/generics/torus.hpp"

#include <variant>

namespace rayscope {

template <Scalar T>
using Generic = std::variant<Sphere<T>, Plane<T>, Cylinder<T>, Cone<T>, Cube<T>, Torus<T>, Polygon<T>,
                             OpenCylinder<T>, OpenCone<T>>;

inline constexpr std::size_t generic_kinds = std::variant_size_v<Generic<double>>;

/// "sphere", "plane", …
template <Scalar T> [[nodiscard]] const char* generic_name(const Generic<T>& generic) {
    return std::visit([](const auto& shape) { return shape.name; }, generic);
}

/// The name of the kind with this Generic::index().
[[nodiscard]] const char* generic_name(std::size_t kind);

/// False for surfaces without volume, which can't be operands of a compound.
template <Scalar T> [[nodiscard]] bool is_solid(const Generic<T>& generic) {
    return std::visit([](const auto& shape) { return shape.solid; }, generic);
}

/// Negative inside, positive outside, zero on the surface, and near it about the distance: object space.
template <Scalar T> [[nodiscard]] T implicit_value(const Generic<T>& generic, const Vec3<T>& p) {
    return std::visit([&](const auto& shape) { return shape.value(p); }, generic);
}

} // namespace rayscope
