#pragma once
// Triangles as a file gives them.

#include "core/math/box.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rayscope {

/// Flat arrays. Every index is that of an element that is there, and every number is finite.
struct MeshData {
    using Corners = std::array<std::uint32_t, 3>;

    std::vector<Vec3d> positions;
    std::vector<Corners> triangles;        ///< counter-clockwise as seen from outside: indices of positions
    std::vector<Vec3<float>> normals;      ///< of any length, to either side, for smooth shading; or none
    std::vector<Corners> triangle_normals; ///< of each corner, where they are not numbered like the positions

    int first_number = 0; ///< what the file calls the first vertex

    [[nodiscard]] bool smooth() const { return !normals.empty(); }
    [[nodiscard]] const Corners& normals_of(std::size_t triangle) const {
        return triangle_normals.empty() ? triangles[triangle] : triangle_normals[triangle];
    }
    [[nodiscard]] Box<double> bounds_of(std::size_t triangle) const {
        Box<double> box;
        for (const std::uint32_t corner : triangles[triangle]) box.include(positions[corner]);
        return box;
    }
    [[nodiscard]] std::size_t bytes() const {
        return positions.capacity() * sizeof(Vec3d) + triangles.capacity() * sizeof(Corners) +
               normals.capacity() * sizeof(Vec3<float>) + triangle_normals.capacity() * sizeof(Corners);
    }
};

} // namespace rayscope
