#include "core/math/decimals.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/polygon_check.hpp"
#include "core/scene/toml_sections.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

namespace rayscope {
namespace {

const std::vector<std::string_view> shapes{"sphere", "plane",   "cylinder", "cone", "cube",
                                           "torus",  "polygon", "triangle", "mesh"};
using Meshes = std::map<std::string, std::shared_ptr<const TriangleMesh>>; // by path: read once
const std::vector<std::string_view> common_keys{"shape", "material", "transform", "priority", "visible"};

std::vector<std::string_view> with(std::vector<std::string_view> keys,
                                   std::initializer_list<std::string_view> more) {
    keys.insert(keys.end(), more);
    return keys;
}

Generic<double> read_polygon(const TomlTable& table, std::string_view shape, Place place) {
    const TomlValue value = table.require("vertices", place, "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]");
    std::vector<Vec3d> vertices;
    for (const TomlValue& vertex : value.list()) vertices.push_back(vertex.vector());
    if (shape == "triangle" && vertices.size() != 3)
        value.fail(fmt::format("a triangle has 3 vertices, found {}", vertices.size()));
    if (const auto problem = polygon_problem(vertices, decimals::flatness)) value.fail(*problem);
    return Polygon<double>(std::move(vertices));
}

Generic<double> read_mesh_shape(const TomlTable& table, Place place, Meshes& meshes) {
    const TomlValue value = table.require("file", place, "file = \"bunny.ply\"");
    const std::filesystem::path path =
        std::filesystem::path(table.source().file()).parent_path() / std::filesystem::path(value.string());
    std::shared_ptr<const TriangleMesh>& mesh = meshes[path.string()];
    if (mesh == nullptr) {
        try {
            mesh = read_mesh(path);
        } catch (const InputError& error) {
            if (error.place.line != 0) throw; // the mesh file's own line says more
            value.fail(fmt::format("mesh {}: {}", in_quotes(path.string()), error.message));
        }
    }
    return Mesh<double>(mesh);
}

Generic<double> read_shape(const TomlTable& table, Place place, Meshes& meshes) {
    const TomlValue value = table.require("shape", place, "shape = \"sphere\"");
    const std::string_view shape = shapes[value.choice(shapes)];
    const std::string kind = fmt::format("a {}", shape);
    if (shape == "torus") {
        table.allow_only(kind, with(common_keys, {"minor_radius"}));
        Torus<double> torus;
        if (const auto minor = table.find("minor_radius")) torus.minor = minor->number({0, 1, true});
        return torus;
    }
    if (shape == "cone") {
        table.allow_only(kind, with(common_keys, {"top_radius"}));
        Cone<double> cone;
        if (const auto top = table.find("top_radius")) {
            cone.top = top->number(from_0_to_1);
            if (cone.top == 1) top->fail("'top_radius': expected less than 1, the radius of the base");
        }
        return cone;
    }
    if (shape == "polygon" || shape == "triangle") {
        table.allow_only(kind, with(common_keys, {"vertices"}));
        return read_polygon(table, shape, place);
    }
    if (shape == "mesh") {
        table.allow_only(kind, with(common_keys, {"file"}));
        return read_mesh_shape(table, place, meshes);
    }
    table.allow_only(kind, common_keys);
    if (shape == "sphere") return Sphere<double>{};
    if (shape == "plane") return Plane<double>{};
    if (shape == "cylinder") return Cylinder<double>{};
    return Cube<double>{};
}

SceneGeneric read_generic(const TomlEntry& entry, const NameIndex& materials, Meshes& meshes) {
    const TomlTable table = entry.value.table();
    table.allow_only("a generic", with(common_keys, {"minor_radius", "top_radius", "vertices", "file"}));
    SceneGeneric generic;
    generic.name = entry.key;
    generic.place = entry.place;
    generic.shape = read_shape(table, entry.place, meshes);
    if (const auto material = table.find("material"))
        generic.material = named(*material, "material", materials);
    if (const auto transform = table.find("transform")) generic.matrix = read_transform(*transform);
    if (const auto priority = table.find("priority"))
        generic.priority = priority->integer(-largest_priority, largest_priority);
    return generic;
}

} // namespace

NameIndex read_generics(const TomlTable& root, const NameIndex& materials, Scene& scene,
                        Visibility& visibility) {
    NameIndex index;
    Meshes meshes;
    if (const auto section = root.find("generics"))
        for (const TomlEntry& entry : section->table().named_entries("a generic")) {
            index.emplace(entry.key, scene.generics.size());
            scene.generics.push_back(read_generic(entry, materials, meshes));
            const auto visible = entry.value.table().find("visible");
            visibility.generics.push_back(visible ? std::optional(visible->boolean()) : std::nullopt);
        }
    visibility.generic_operands.resize(scene.generics.size());
    return index;
}

} // namespace rayscope
