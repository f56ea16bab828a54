#include "core/scene/mesh_file.hpp"

#include "core/scene/mesh_builder.hpp"
#include "core/scene/source_text.hpp"

#include <fmt/format.h>

namespace rayscope {

bool is_mesh_file(const std::filesystem::path& path) {
    return path.extension() == ".obj" || path.extension() == ".ply";
}

std::shared_ptr<const TriangleMesh> read_mesh(const std::filesystem::path& path) {
    if (!is_mesh_file(path))
        throw InputError(path.string(), {}, "not a mesh: its name must end in .obj or .ply");
    MeshData data;
    {
        std::string text = read_file(path, mesh_limits::most_bytes);
        data = path.extension() == ".obj" ? parse_obj(std::move(text), path.string())
                                          : parse_ply(text, path.string());
    }
    data.positions.shrink_to_fit();
    data.triangles.shrink_to_fit();
    data.normals.shrink_to_fit();
    data.triangle_normals.shrink_to_fit();
    return std::make_shared<const TriangleMesh>(std::move(data));
}

std::string hole_text(const TriangleMesh& mesh) {
    if (!mesh.hole()) return {};
    const Hole& hole = *mesh.hole();
    const auto vertex = [&](std::uint32_t index) {
        const Vec3d& p = mesh.data().positions[index];
        return fmt::format("vertex {} ({:.6g}, {:.6g}, {:.6g})",
                           index + std::uint32_t(mesh.data().first_number), p.x, p.y, p.z);
    };
    const int faces = hole.along + hole.against;
    return fmt::format(
        "has a hole at the edge from {} to {}: {} {} there{}, where each face needs another that "
        "runs along the edge the other way",
        vertex(hole.from), vertex(hole.to), faces, faces == 1 ? "triangle ends" : "triangles meet",
        faces == 1 ? "" : fmt::format(", {} running one way and {} the other", hole.along, hole.against));
}

Scene mesh_scene(const std::filesystem::path& path) {
    const auto mesh = read_mesh(path);
    const Box<double>& box = mesh->bounds();
    const Vec3d middle = (box.low + box.high) / 2.0;
    const double size = length(box.high - box.low) / 2;
    const double radius = size > 0 ? size : 1;

    Scene scene;
    scene.file = path.string();
    scene.background = Colour{0.2, 0.25, 0.3};
    scene.camera.look_at = middle;
    // The ball around the box fills the image: its radius over its distance is the sine of half the field of view.
    scene.camera.field_of_view = 40;
    const double distance = radius / 0.342;
    scene.camera.eye = middle + distance * normalized(Vec3d{0.4, 0.35, 1});
    for (const Vec3d& from : {Vec3d{-0.3, 0.8, 1}, Vec3d{1, 0.3, 0.4}}) {
        SceneLight light;
        light.name = fmt::format("l{}", scene.lights.size() + 1);
        light.directional = true;
        light.position = normalized(from);
        light.colour = Colour{scene.lights.empty() ? 0.8 : 0.35};
        scene.lights.push_back(light);
    }
    SceneMaterial material;
    material.name = "grey";
    scene.materials.push_back(material);
    SceneGeneric generic;
    generic.name = path.stem().string();
    generic.shape = Mesh<double>(mesh);
    generic.material = 0;
    scene.drawn.push_back({false, 0});
    scene.generics.push_back(std::move(generic));
    return scene;
}

} // namespace rayscope
