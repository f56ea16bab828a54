#pragma once
// Mesh files: OBJ and PLY. What is taken from them and how: chapters/reference/scene-format.md.

#include "core/mesh/triangle_mesh.hpp"
#include "core/scene/scene.hpp"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace rayscope {

/// True for what read_mesh can read, by its extension.
[[nodiscard]] bool is_mesh_file(const std::filesystem::path& path);

/// Throws InputError.
[[nodiscard]] std::shared_ptr<const TriangleMesh> read_mesh(const std::filesystem::path& path);

/// The same from a text in memory; `file` is what messages call it.
[[nodiscard]] MeshData parse_obj(std::string text, std::string file);
[[nodiscard]] MeshData parse_ply(std::string_view text, std::string file);

/// "has a hole at the edge from vertex 3 (0, 0, 1) to vertex 7 (…): …"; empty for a closed mesh. Why it is no solid.
[[nodiscard]] std::string hole_text(const TriangleMesh& mesh);

/// A scene of this mesh alone: grey, seen from before, a little from above and from the right, so that all of it is in the image, in
/// the light of two lamps.
[[nodiscard]] Scene mesh_scene(const std::filesystem::path& path);

} // namespace rayscope
