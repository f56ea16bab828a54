#pragma once
// The pieces of a mesh that hang together.

#include "core/mesh/mesh_data.hpp"

namespace rayscope::povray {

/// Whether two pieces that share no vertex may reach into each other: their boxes overlap.
[[nodiscard]] bool parts_may_overlap(const MeshData& mesh);

} // namespace rayscope::povray
