#pragma once
// Whether triangles enclose a volume.

#include "core/mesh/mesh_data.hpp"

#include <optional>

namespace rayscope {

/// An edge along which a mesh is open: not as many triangles run along it one way as the other.
struct Hole {
    std::uint32_t from, to; ///< indices of positions
    int along, against;     ///< triangles that run from → to, and back
};

/// Nothing for a closed mesh. Vertices at the same place are one, whatever their number: files part them where normals
/// or colours differ.
/// Where each edge is run along as often one way as the other, a line that crosses no edge goes in as often as out. So two
/// parts may also share an edge.
[[nodiscard]] std::optional<Hole> find_hole(const MeshData& mesh);

/// Six times the volume enclosed, negative where the triangles are inside out.
[[nodiscard]] double signed_volume(const MeshData& mesh);

} // namespace rayscope
