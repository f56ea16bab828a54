#include "core/povray/differences.hpp"

#include "core/povray/flush_faces.hpp"
#include "core/povray/textures.hpp"

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
        const auto casts = [](const SceneLight& light) { return light.shadows; };
        if (std::none_of(scene_.lights.begin(), scene_.lights.end(), casts)) return;
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
                say("material '{}': its index is that of yellow light for all colours", material.name);
            if (material.mirror == Mirror::schlick)
                say("material '{}': Fresnel's equations take the place of Schlick's approximation",
                    material.name);
        }
        // Of a compound's walls each would have its operand's space.
        for (std::size_t id = 0; id < scene_.drawn.size(); ++id) {
            const std::uint32_t material = world_.objects[id].material;
            if (scene_.materials[material].patterns.any() &&
                (scene_.drawn[id].is_compound || !Textures(scene_).shows_patterns(material)))
                say("material '{}': its patterns are left out, their means are taken",
                    scene_.materials[material].name);
        }
        for (const SceneLight& light : scene_.lights)
            if (light.area.samples > 1) say("light '{}': its area is asked at points of a grid", light.name);
        if (scene_.camera.samples > 1)
            say("samples are left out: POV-Ray's own antialiasing is an option of its command line, +A");
    }

    void find_in_media() {
        std::set<std::uint32_t> mirrors;
        bool bends = false, overlap = false;
        for (const std::uint32_t object : world_.media.all()) {
            const Material& material = world_.material_of(object);
            const Colour share = material.reflection + material.transmission;
            bends = bends || material.speed != world_.medium_speed;
            if (material.speed != world_.medium_speed && minimum(share.x, minimum(share.y, share.z)) < 1)
                mirrors.insert(world_.objects[object].material);
            world_.media.each_near(
                object, [&](std::uint32_t other) { overlap = overlap || needs_rule(object, other); });
        }
        // A ray that is reflected totally carries reflection + transmission here, all there.
        if (!mirrors.empty())
            say("total reflection mirrors all light, not reflection + transmission ({})", names(mirrors));
        if (world_.notes_media && bends)
            say("media = \"notes\" is left out: POV-Ray knows the medium that a ray comes from");
        else if (overlap)
            say("where transparent solids overlap in part, the medium is the one that the ray entered last");
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
        std::size_t smooth = 0, flattened = 0;
        for (const SceneGeneric& generic : scene_.generics)
            if (const auto* polygon = std::get_if<Polygon<double>>(&generic.shape);
                polygon != nullptr && polygon->smooth())
                ++(is_fan(*polygon) ? smooth : flattened);
        if (smooth > 0)
            say("where a smooth polygon's normal turns away from the eye, POV-Ray turns it back, instead of "
                "taking "
                "the flat one");
        if (flattened > 0) say("{} smooth polygons that are not convex are shaded as flat ones", flattened);
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

bool is_fan(const Polygon<double>& polygon) {
    const auto& corners = polygon.vertices();
    const Vec3d normal = area_vector(corners);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        if (!(dot(normal, cross(corners[i] - corners[0], corners[i + 1] - corners[0])) > 0)) return false;
    return true;
}

std::vector<std::string> differences(const Scene& scene, const WorldBase& world) {
    return Differences(scene, world).find();
}

} // namespace rayscope::povray
