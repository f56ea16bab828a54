#include "core/povray/differences.hpp"

#include "core/povray/flush_faces.hpp"
#include "core/povray/mesh_parts.hpp"
#include "core/povray/textures.hpp"
#include "core/scene/expand.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace rayscope::povray {
namespace {

bool is_grey(const Colour& c) { return c.x == c.y && c.y == c.z; }

class Differences {
public:
    Differences(const Scene& scene, const WorldBase& world) : scene_(scene), world_(world) {}

    std::vector<std::string> find() {
        find_in_limits();
        find_in_lights();
        find_in_materials();
        find_in_effects();
        find_in_media();
        find_in_shapes();
        find_in_compounds();
        return std::move(found_);
    }

private:
    template <typename... Parts> void say(fmt::format_string<Parts...> text, Parts&&... parts) {
        found_.push_back(fmt::format(text, std::forward<Parts>(parts)...));
    }

    void find_in_limits() {
        if (scene_.limits.max_depth >= most_trace_levels)
            say("max_depth {} is cut to {}", scene_.limits.max_depth, most_trace_levels - 1);
        if (scene_.limits.max_rays != Limits{}.max_rays)
            say("max_rays {} is left out: POV-Ray does not limit the rays of a pixel",
                scene_.limits.max_rays);
    }

    // Where no light has shadows, the objects cast none, and nothing is lost.
    void find_in_lights() {
        if (!casts_shadows(scene_)) return;
        for (const SceneLight& light : scene_.lights)
            if (!light.shadows) say("light '{}' has no shadows, and so no highlights in POV-Ray", light.name);
    }

    void find_in_materials() {
        for (const SceneMaterial& material : scene_.materials)
            if (!is_grey(material.specular))
                say("material '{}': the colour of its highlights is averaged to grey", material.name);
    }

    void find_in_effects() {
        for (const SceneMaterial& material : scene_.materials) {
            if (material.dispersion.spreads())
                say("material '{}': its colours and indices are POV-Ray's own, through two points of the "
                    "curve",
                    material.name);
            if (material.mirror == Mirror::schlick)
                say("material '{}': Fresnel's equations take the place of Schlick's approximation",
                    material.name);
            if (material.mirror != Mirror::constant && casts_shadows(scene_))
                say("material '{}': its shadows are paler: they do not lack what it mirrors", material.name);
        }
        std::set<std::uint32_t> lost;
        for (const SceneObject& drawn : scene_.drawn) find_lost_patterns(drawn, lost);
        for (const std::uint32_t material : lost)
            say("material '{}': its patterns are left out, their means are taken",
                scene_.materials[material].name);
        for (const SceneLight& light : scene_.lights)
            if (light.area.is_sampled()) say("light '{}': its area is asked at points of a grid", light.name);
        if (scene_.camera.samples > 1)
            say("samples are left out: POV-Ray's own antialiasing is an option of its command line, +A");
    }

    // By the wall's material, where it is not the object's reflection that has a pattern.
    void find_lost_patterns(const SceneObject& drawn, std::set<std::uint32_t>& lost) const {
        const Textures textures(scene_);
        const auto ask = [&](std::size_t object, std::size_t wall) {
            if (textures.loses_patterns(object, wall))
                lost.insert(std::uint32_t(scene_.materials[wall].patterns.any() ? wall : object));
        };
        if (!drawn.is_compound) {
            const std::size_t material = *scene_.generics[drawn.index].material;
            return ask(material, material);
        }
        const std::size_t whole = *scene_.compounds[drawn.index].material;
        for (const ExpandedNode& node : expand(scene_, drawn.index))
            if (node.operation == Operation::leaf) ask(whole, node.material.value_or(whole));
    }

    void find_in_media() {
        std::set<std::uint32_t> mirrors;
        bool bends = false, overlap = false, fades = false;
        for (const std::uint32_t object : world_.media.all()) {
            const Material& material = world_.material_of(object);
            const Colour share = material.reflection + material.transmission;
            bends = bends || material.speed != world_.medium_speed;
            if (material.speed != world_.medium_speed && minimum(share.x, minimum(share.y, share.z)) < 1)
                mirrors.insert(world_.objects[object].material);
            world_.media.each_near(object, [&](std::uint32_t other) {
                overlap = overlap || needs_rule(object, other);
                fades = fades || material.absorbs();
            });
        }
        // A ray that is reflected totally carries reflection + transmission here, all there.
        if (!mirrors.empty())
            say("total reflection mirrors all light, not reflection + transmission ({})", names(mirrors));
        if (world_.notes_media && bends)
            say("media = \"notes\" is left out: POV-Ray knows the medium that a ray comes from");
        else if (overlap)
            say("where transparent solids overlap in part, the medium is the one that the ray entered last");
        if (fades) say("light fades in another way where a solid lies in one that absorbs");
    }

    [[nodiscard]] std::string names(const std::set<std::uint32_t>& materials) const {
        if (materials.size() > 3) return fmt::format("{} materials", materials.size());
        std::string text;
        for (const std::uint32_t material : materials)
            text += (text.empty() ? "" : ", ") + scene_.materials[material].name;
        return text;
    }

    // Extents that reach out of each other on both sides: the solids themselves may cut each other.
    [[nodiscard]] bool needs_rule(std::uint32_t a, std::uint32_t b) const {
        const Object &first = world_.objects[a], &second = world_.objects[b];
        if (first.priority != second.priority) return true;
        const auto within = [](const Box<double>& inner, const Box<double>& outer) {
            for (int i = 0; i < 3; ++i)
                if (inner.low[i] < outer.low[i] || inner.high[i] > outer.high[i]) return false;
            return true;
        };
        // Of two that nest, ours takes the later one; so does the ray that enters the inner one last.
        return !within((a < b ? second : first).bounds, (a < b ? first : second).bounds);
    }

    void find_in_shapes() {
        const bool smooth = std::ranges::any_of(scene_.generics, [](const SceneGeneric& generic) {
            const auto* polygon = std::get_if<Polygon<double>>(&generic.shape);
            return polygon != nullptr && polygon->smooth();
        });
        for (std::size_t id = 0; id < scene_.drawn.size(); ++id) {
            const SceneObject& drawn = scene_.drawn[id];
            if (drawn.is_compound || !world_.material_of(std::uint32_t(id)).transmits()) continue;
            const auto* mesh = std::get_if<Mesh<double>>(&scene_.generics[drawn.index].shape);
            if (mesh != nullptr && mesh->solid && parts_may_overlap(mesh->triangles().data()))
                say("mesh '{}': where its parts overlap, their inner walls are seen",
                    scene_.generics[drawn.index].name);
        }
        if (smooth)
            say("where a smooth polygon's normal turns away from the eye, POV-Ray turns it back, instead of "
                "taking the flat one");
    }

    void find_in_compounds() {
        for (const SceneObject& drawn : scene_.drawn) {
            if (!drawn.is_compound) continue;
            const auto flush = flush_operands(scene_, drawn.index);
            if (!flush) continue;
            say("compound '{}': '{}' and '{}' have faces in one plane, where rounding decides, pixel by "
                "pixel, "
                "what POV-Ray sees",
                scene_.compounds[drawn.index].name, scene_.generics[flush->first].name,
                scene_.generics[flush->second].name);
        }
    }

    const Scene& scene_;
    const WorldBase& world_;
    std::vector<std::string> found_;
};

} // namespace

bool casts_shadows(const Scene& scene) { return std::ranges::any_of(scene.lights, &SceneLight::shadows); }

std::vector<std::string> differences(const Scene& scene, const WorldBase& world) {
    return Differences(scene, world).find();
}

} // namespace rayscope::povray
