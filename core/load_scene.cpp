// The public face: scenes from files.

#include "core/math/hash.hpp"
#include "core/rayscope.hpp"
#include "core/scene/build.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/read_nff.hpp"
#include "core/scene/read_toml.hpp"
#include "core/scene/source_text.hpp"

#include <fmt/format.h>

namespace rayscope {
namespace {

Scene read_scene(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    if (extension == ".toml") return read_toml(path);
    if (extension == ".nff") return read_nff(path);
    if (is_mesh_file(path)) return mesh_scene(path);
    throw InputError(path.string(), {}, "not a scene: its name must end in .toml, .nff, .obj or .ply");
}

std::string names_of(const EffectSet& some, const EffectSet& others) {
    std::string names;
    for (std::size_t i = 0; i < effect_names.size(); ++i)
        if (some.has(Effect(i)) && !others.has(Effect(i)))
            names.append(names.empty() ? "" : ", ").append(effect_names[i].name);
    return names;
}

Fnv1a hash_of_bytes(const std::filesystem::path& path) {
    const std::string text = read_file(path, std::size_t(1) << 30U);
    return Fnv1a().add(text.data(), text.size());
}

std::string in_digits(const Fnv1a& hash) { return fmt::format("{:016x}", hash.value()); }

template <typename Element> void add_elements(Fnv1a& hash, const std::vector<Element>& list) {
    hash.add(list.data(), list.size() * sizeof(Element));
}

// For experiments: not what the scene calls for.
Scene with_chosen_effects(Scene scene, const std::optional<std::string>& text) {
    const EffectSet needed = needed_effects(effect_needs(scene, build(scene)));
    const EffectSet wanted = text ? parse_effects(*text, needed) : *scene.effects;
    scene = with_effects(std::move(scene), needed, wanted);
    const EffectSet now = needed_effects(effect_needs(scene, build(scene)));
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        const auto effect = Effect(i);
        const bool was = needed.has(effect), asked = wanted.has(effect), is = now.has(effect);
        scene.taken_away.set(effect, was && !asked);
        scene.went_along.set(effect, was && asked && !is);
        scene.added.set(effect, !was && asked && is);
    }
    const auto warn = [&](const char* what, const EffectSet& some, const EffectSet& others) {
        if (const std::string names = names_of(some, others); !names.empty())
            scene.warnings.push_back(fmt::format("{}: {}: {}", scene.file, what, names));
    };
    warn("simulated though nothing in the scene calls for it", scene.added, {});
    warn("asked for, but there is nothing in the scene to add it to", wanted, united(now, needed));
    warn("called for by the scene, and not simulated, as it was asked", scene.taken_away, {});
    warn("called for by what was changed or taken away, and gone with it", scene.went_along, {});
    return scene;
}

} // namespace

Scene load_scene(const std::filesystem::path& path, const std::optional<std::string>& effects) {
    Scene scene = read_scene(path);
    return effects || scene.effects ? with_chosen_effects(std::move(scene), effects) : scene;
}

std::string content_hash(const std::filesystem::path& path) { return in_digits(hash_of_bytes(path)); }

std::string content_hash(const std::filesystem::path& path, const Scene& scene) {
    Fnv1a hash = hash_of_bytes(path);
    for (const SceneGeneric& generic : scene.generics)
        if (const auto* mesh = std::get_if<Mesh<double>>(&generic.shape)) {
            const MeshData& data = mesh->triangles().data();
            add_elements(hash, data.positions);
            add_elements(hash, data.triangles);
            add_elements(hash, data.normals);
            add_elements(hash, data.triangle_normals);
        }
    return in_digits(hash);
}

} // namespace rayscope
