#include "core/scene/read_toml.hpp"

#include "core/scene/toml_guard.hpp"
#include "core/scene/toml_sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace rayscope {
namespace {

// A text of this size may already need two GiB as a document.
constexpr std::size_t most_toml_bytes = std::size_t(64) << 20U;

toml::table parse(const SourceText& source) {
    try {
        return toml::parse(source.text());
    } catch (const toml::parse_error& error) {
        const auto& begin = error.source().begin;
        source.fail({int(begin.line), int(begin.column)}, std::string(error.description()));
    }
}

// An operand is drawn only where its author says so, everything else unless its author says not.
void settle_visibility(const Visibility& visibility, Scene& scene) {
    for (std::size_t i = 0; i < scene.generics.size(); ++i)
        scene.generics[i].visible = visibility.generics[i].value_or(!visibility.generic_operands[i]);
    for (std::size_t i = 0; i < scene.compounds.size(); ++i)
        scene.compounds[i].visible = visibility.compounds[i].value_or(!visibility.compound_operands[i]);
}

template <typename Solid>
void require_material(const SourceText& source, const Solid& solid, const char* kind) {
    if (!solid.material)
        source.fail(solid.place, fmt::format("{} '{}' is drawn and needs a material, for example material = "
                                             "\"NAME\" with [materials.NAME]",
                                             kind, solid.name));
}

void list_drawn(const SourceText& source, Scene& scene) {
    for (std::size_t i = 0; i < scene.generics.size(); ++i)
        if (scene.generics[i].visible) scene.drawn.push_back({false, i});
    for (std::size_t i = 0; i < scene.compounds.size(); ++i)
        if (scene.compounds[i].visible) scene.drawn.push_back({true, i});
    const auto place = [&](const SceneObject& object) {
        const Place p =
            object.is_compound ? scene.compounds[object.index].place : scene.generics[object.index].place;
        return std::tuple(p.line, p.column);
    };
    std::sort(scene.drawn.begin(), scene.drawn.end(),
              [&](const SceneObject& a, const SceneObject& b) { return place(a) < place(b); });
    for (const SceneObject& object : scene.drawn) {
        if (object.is_compound)
            require_material(source, scene.compounds[object.index], "compound");
        else
            require_material(source, scene.generics[object.index],
                             generic_name(scene.generics[object.index].shape));
    }
    if (scene.drawn.empty())
        scene.warnings.push_back(
            fmt::format("{}: nothing is drawn: the scene has no visible solid", source.file()));
}

} // namespace

Scene parse_toml(std::string_view text, std::string file) {
    SourceText source(std::move(file), text);
    source.reject_binary();
    guard_toml_parser(source);
    const toml::table document = parse(source);
    const TomlTable root(source, document, "scene");
    root.allow_only("a scene",
                    {"camera", "lights", "materials", "generics", "compounds", "scene", "limits", "step"});

    Scene scene;
    scene.file = source.file();
    read_camera(root, scene);
    read_settings(root, scene);
    read_lights(root, scene);
    const NameIndex materials = read_materials(root, scene);
    Visibility visibility;
    const NameIndex generics = read_generics(root, materials, scene, visibility);
    read_compounds(source, root, materials, generics, scene, visibility);
    reject_cycles(source, scene);
    settle_visibility(visibility, scene);
    list_drawn(source, scene);
    return scene;
}

Scene read_toml(const std::filesystem::path& path) {
    return parse_toml(read_file(path, most_toml_bytes), path.string());
}

} // namespace rayscope
