#pragma once
// A piece of a surface.

#include "core/rayscope.hpp"

#include <array>
#include <vector>

namespace rayscope::page {

/// World coordinates; corners counter-clockwise as seen from outside. Triangles that share a corner are smooth there.
struct Triangles {
    std::vector<Vec3d> corners;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    void append(const Triangles& other);
};

} // namespace rayscope::page
