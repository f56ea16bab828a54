#pragma once
// What the readers of mesh files have in common: polygons with checked corners become triangles.

#include "core/math/vec.hpp"
#include "core/mesh/triangulate.hpp"

namespace rayscope {

namespace mesh_limits {
inline constexpr std::size_t most_bytes = std::size_t(1) << 30U; ///< of a file
inline constexpr std::size_t most_corners = 1024;                ///< of a polygon: cutting takes their square
inline constexpr double most = 1e100; ///< of a coordinate: its square is a double, too
} // namespace mesh_limits

class MeshBuilder {
public:
    MeshData mesh;

    void add_normal(const Vec3d& n) { mesh.normals.push_back(as<float>(normalized(n))); }

    /// @param corners indices of positions, at least three
    /// @param normals of normals, as many; or none: the face is flat
    void add_face(std::span<const std::uint32_t> corners, std::span<const std::uint32_t> normals = {}) {
        outline_.clear();
        for (const std::uint32_t corner : corners) outline_.push_back(mesh.positions[corner]);
        for (const MeshData::Corners& t : triangulation_.of(outline_)) {
            mesh.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
            if (!normals.empty())
                mesh.triangle_normals.push_back({normals[t[0]], normals[t[1]], normals[t[2]]});
        }
    }

private:
    Triangulation triangulation_;
    std::vector<Vec3d> outline_;
};

} // namespace rayscope
