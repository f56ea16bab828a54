#pragma once
// The generics that tests try one after the other.

#include "core/world/solid.hpp"

namespace rayscope::test {

/// Every solid generic, with parameters that its default would hide.
[[nodiscard]] inline std::vector<Generic<double>> solid_generics() {
    return {Sphere<double>{},  Sphere<double>{1.75}, Plane<double>{}, Cylinder<double>{}, Cone<double>{},
            Cone<double>{0.5}, Cube<double>{},       Torus<double>{}, Torus<double>{0.6}};
}

[[nodiscard]] inline Polygon<double> triangle() {
    return Polygon<double>({{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
}

[[nodiscard]] inline std::vector<Generic<double>> all_generics() {
    std::vector<Generic<double>> shapes = solid_generics();
    shapes.emplace_back(triangle());
    shapes.emplace_back(OpenCylinder<double>{});
    shapes.emplace_back(OpenCone<double>{0.25});
    return shapes;
}

[[nodiscard]] inline Intervals<double> intervals(const Generic<double>& shape, const Ray<double>& ray,
                                                 int leaving = no_face) {
    return std::visit([&](const auto& s) { return s.intervals(ray, leaving); }, shape);
}

[[nodiscard]] inline Solid<double> placed(const Generic<double>& shape, const Mat4d& matrix) {
    Solid<double> solid;
    solid.shape = shape;
    solid.transform = Transform<double>(matrix);
    return solid;
}

} // namespace rayscope::test
