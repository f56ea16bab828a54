#pragma once
// Polygons of a mesh, cut into triangles.

#include "core/mesh/mesh_data.hpp"

#include <span>

namespace rayscope {

/// Whether the triangles from the first corner to each side are the polygon, as those of a convex one are; the last one must
/// have an area.
[[nodiscard]] bool is_fan(std::span<const Vec3d> corners);

/// Ears are cut off (Meisters 1975) until three corners are left: n − 2 triangles that run around like the outline, which
/// may be concave. Each side of the outline is a side of one of them, each cut one of two, whatever the outline: a closed
/// mesh stays closed. Takes n² steps at most.
/// @param corners at least three
/// @return the triangles' corners, as places in `corners`; valid until the next call
class Triangulation {
public:
    [[nodiscard]] std::span<const MeshData::Corners> of(std::span<const Vec3d> corners);

private:
    [[nodiscard]] bool is_ear(std::size_t at) const;

    std::vector<std::array<double, 2>> flat_; // seen along the normal's largest component
    std::vector<std::uint32_t> left_;         // corners that are not cut off
    std::vector<MeshData::Corners> triangles_;
};

} // namespace rayscope
