#pragma once
// One solid and one ray: what the properties of this folder are asked about. A failing case is printed as one line that
// can be pasted into corpus.inc, where all of them are asked about it first.

#include "tests/support/hex.hpp"
#include "tests/support/shapes.hpp"

namespace rayscope::test {

struct Case {
    Generic<double> shape;
    Mat4d matrix{1};
    Ray<double> ray;
    Vec3d next{0};    ///< where the ray goes on from the hit, across the normal …
    double slope = 0; ///< … and along it
    Vec3d wall{0};    ///< normal of a plane in the way of that ray; none if 0
    double gap = 0;   ///< how far away it stands, in roundings of the place
};

/// What a property says of a case: what is wrong, if anything, and whether it could tell.
struct Verdict {
    std::string wrong; ///< empty: nothing
    bool decided = true;
};

[[nodiscard]] inline std::string shape_text(const Generic<double>& shape) {
    const auto braced = [](const char* name, const std::string& value) {
        return std::string(name).append("<double>{").append(value).append("}");
    };
    if (const auto* s = std::get_if<Sphere<double>>(&shape)) return braced("Sphere", hex(s->radius));
    if (std::holds_alternative<Plane<double>>(shape)) return braced("Plane", "");
    if (std::holds_alternative<Cylinder<double>>(shape)) return braced("Cylinder", "");
    if (const auto* s = std::get_if<Cone<double>>(&shape)) return braced("Cone", hex(s->top));
    if (std::holds_alternative<Cube<double>>(shape)) return braced("Cube", "");
    if (const auto* s = std::get_if<Torus<double>>(&shape)) return braced("Torus", hex(s->minor));
    if (std::holds_alternative<OpenCylinder<double>>(shape)) return braced("OpenCylinder", "");
    if (const auto* s = std::get_if<OpenCone<double>>(&shape)) return braced("OpenCone", hex(s->top));
    return "triangle()";
}

/// A line of corpus.inc.
[[nodiscard]] inline std::string line_of(const Case& c) {
    std::string line = "{";
    return line.append(shape_text(c.shape))
        .append(", ")
        .append(hex(c.matrix))
        .append(", ")
        .append(hex(c.ray))
        .append(", ")
        .append(hex(c.next))
        .append(", ")
        .append(hex(c.slope))
        .append(", ")
        .append(hex(c.wall))
        .append(", ")
        .append(hex(c.gap))
        .append("},");
}

/// The cases that once were wrong, or nearly.
[[nodiscard]] inline const std::vector<Case>& corpus() {
    static const std::vector<Case> cases{
#include "tests/stability/corpus.inc"
    };
    return cases;
}

} // namespace rayscope::test
