#include "core/effects/effect_needs.hpp"

#include "core/effects/used_materials.hpp"
#include "core/scene/name_trace.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope {
namespace {

bool is_anywhere(const Colour& colour, const std::optional<Pattern>& pattern) {
    return largest_component(largest_of(colour, pattern)) > 0;
}

class Finder {
public:
    Finder(const Scene& scene, const WorldBase& world)
        : scene_(scene), world_(world), used_(used_materials(scene)) {}

    [[nodiscard]] std::vector<EffectNeed> all() {
        ambient();
        of_material(Effect::diffuse, "scatters light", "no drawn material has a diffuse coefficient",
                    lit(&SceneMaterial::diffuse, &Patterns::diffuse));
        of_material(Effect::specular, "has highlights", "no drawn material has a specular coefficient",
                    lit(&SceneMaterial::specular, &Patterns::specular));
        shadows();
        of_object(Effect::reflection, "mirrors", "no drawn object has a reflection coefficient",
                  [](const SceneMaterial& m) {
                      return m.mirror != Mirror::constant || is_anywhere(m.reflection, m.patterns.reflection);
                  });
        of_object(Effect::refraction, "lets light through", "no drawn object transmits light",
                  &SceneMaterial::transmits);
        nested_media();
        soft_shadows();
        fresnel();
        of_medium(Effect::absorption, "absorbs light inside", "no medium has an absorption",
                  [](const SceneMaterial& m) { return largest_component(m.absorption) > 0; });
        of_medium(Effect::dispersion, "bends each colour by an index of its own",
                  "no medium's index depends on the colour",
                  [](const SceneMaterial& m) { return m.dispersion.spreads(); });
        antialiasing();
        patterns();
        return std::move(needs_);
    }

private:
    using Lit = std::function<bool(const SceneMaterial&)>;

    static Lit lit(Colour SceneMaterial::* colour, std::optional<Pattern> Patterns::* pattern) {
        return [=](const SceneMaterial& m) { return is_anywhere(m.*colour, m.patterns.*pattern); };
    }

    void add(Effect effect, bool needed, std::string reason) {
        if (needed && scene_.added.has(effect)) reason = "added, as it was asked";
        if (!needed && scene_.taken_away.has(effect)) reason = "taken away, as it was asked";
        if (!needed && scene_.went_along.has(effect)) reason = "what called for it was changed or taken away";
        if (!needed && effect == Effect::reflection && follows() &&
            first(true, &SceneMaterial::transmits) != nullptr)
            reason += "; what is reflected totally belongs to refraction";
        needs_.push_back({effect, needed, std::move(reason)});
    }
    [[nodiscard]] bool needs(Effect effect) const {
        return std::ranges::any_of(needs_,
                                   [&](const EffectNeed& n) { return n.effect == effect && n.needed; });
    }
    [[nodiscard]] std::string at(Place place) const {
        return place.line > 0 ? fmt::format(", {}:{}", scene_.file, place.line) : "";
    }
    [[nodiscard]] Place place_of(std::size_t drawn) const {
        const SceneObject& object = scene_.drawn[drawn];
        return object.is_compound ? scene_.compounds[object.index].place
                                  : scene_.generics[object.index].place;
    }
    [[nodiscard]] std::string title(std::size_t drawn) const {
        return object_title(scene_, scene_.drawn[drawn]);
    }
    [[nodiscard]] const UsedMaterial* first(bool of_objects, const Lit& asks) const {
        for (const UsedMaterial& used : used_)
            if ((used.is_object || !of_objects) && asks(scene_.materials[used.material])) return &used;
        return nullptr;
    }
    void from(Effect effect, const UsedMaterial* used, const char* does, const char* otherwise) {
        if (used == nullptr) {
            add(effect, false, otherwise);
            return;
        }
        const SceneMaterial& material = scene_.materials[used->material];
        add(effect, true,
            fmt::format("material '{}' of '{}' {}{}", material.name, title(used->object), does,
                        at(material.place)));
    }
    [[nodiscard]] bool any_light_shines() const {
        return std::ranges::any_of(scene_.lights, &SceneLight::shines);
    }
    [[nodiscard]] std::string no_light() const {
        return scene_.lights.empty() ? "there is no light" : "no light shines: their colours are 0";
    }
    void of_material(Effect effect, const char* does, const char* otherwise, const Lit& asks) {
        const UsedMaterial* used = first(false, asks);
        const bool from_lights = effect == Effect::diffuse || effect == Effect::specular;
        if (from_lights && used != nullptr && !any_light_shines())
            add(effect, false, no_light());
        else
            from(effect, used, does, otherwise);
    }
    [[nodiscard]] bool follows() const { return scene_.limits.max_depth > 0; }
    void of_object(Effect effect, const char* does, const char* otherwise, const Lit& asks) {
        const UsedMaterial* used = first(true, asks);
        if (used != nullptr && !follows())
            add(effect, false, nothing_follows);
        else
            from(effect, used, does, otherwise);
    }
    // A surface alone may have the place of a medium's wall, and then shares out its light.
    void fresnel() {
        const UsedMaterial* used =
            first(true, [](const SceneMaterial& m) { return m.mirror != Mirror::constant; });
        if (used != nullptr && !follows() && !needs(Effect::shadows))
            add(Effect::fresnel, false, nothing_follows);
        else
            from(Effect::fresnel, used, "has fresnel set", "no drawn object's material has fresnel set");
    }
    // What only media do.
    void of_medium(Effect effect, const char* does, const char* otherwise, const Lit& asks) {
        for (const std::uint32_t object : world_.media.all()) {
            const std::size_t material = world_.objects[object].material;
            if (!world_.objects[object].has_volume || !asks(scene_.materials[material])) continue;
            const bool in_shadows = effect != Effect::dispersion && needs(Effect::shadows);
            const bool before_the_eye = effect == Effect::absorption && holds_eye(object);
            if (!follows() && !in_shadows && !before_the_eye) return add(effect, false, nothing_follows);
            const UsedMaterial used{material, object, true};
            return from(effect, &used, does, otherwise);
        }
        add(effect, false, otherwise);
    }
    // Perhaps.
    [[nodiscard]] bool holds_eye(std::uint32_t object) const {
        Box<double> eye;
        eye.include(scene_.camera.eye);
        return world_.objects[object].bounds.overlaps(eye);
    }
    // Those of coefficients that something is multiplied by.
    void patterns() {
        const bool ambient = largest_component(scene_.ambient) > 0, light = any_light_shines();
        const bool through = follows() || needs(Effect::shadows);
        for (const UsedMaterial& used : used_) {
            const Patterns& p = scene_.materials[used.material].patterns;
            if ((p.ambient && ambient) || ((p.diffuse || p.specular) && light) ||
                (used.is_object && ((p.reflection && follows()) || (p.transmission && through))))
                return from(Effect::patterns, &used, "has a coefficient with a pattern", "");
        }
        add(Effect::patterns, false, "no coefficient that counts has a pattern");
    }
    [[nodiscard]] const UsedMaterial* first_lit() const {
        return first(false, [](const SceneMaterial& m) {
            return is_anywhere(m.diffuse, m.patterns.diffuse) || is_anywhere(m.specular, m.patterns.specular);
        });
    }

    void ambient() {
        if (!(largest_component(scene_.ambient) > 0))
            add(Effect::ambient, false, "the scene's ambient light is 0");
        else
            of_material(Effect::ambient, "answers to ambient light",
                        "no drawn material has an ambient coefficient",
                        lit(&SceneMaterial::ambient, &Patterns::ambient));
    }
    void shadows() {
        const auto light =
            std::ranges::find_if(scene_.lights, [](const SceneLight& l) { return l.shines() && l.shadows; });
        if (!any_light_shines())
            add(Effect::shadows, false, no_light());
        else if (light == scene_.lights.end())
            add(Effect::shadows, false, "no light casts them: shadows = false");
        else if (first_lit() == nullptr)
            add(Effect::shadows, false, no_answer);
        else
            add(Effect::shadows, true, fmt::format("light '{}' casts them{}", light->name, at(light->place)));
    }
    void soft_shadows() {
        const auto light = std::ranges::find_if(
            scene_.lights, [](const SceneLight& l) { return l.shines() && l.area.is_sampled(); });
        if (light == scene_.lights.end())
            add(Effect::soft_shadows, false,
                std::ranges::any_of(scene_.lights, [](const SceneLight& l) { return l.area.is_sampled(); })
                    ? "no light with an area shines: their colours are 0"
                    : "no light has an area: one point of each tells");
        else if (first_lit() == nullptr)
            add(Effect::soft_shadows, false, no_answer);
        else
            add(Effect::soft_shadows, true,
                fmt::format("light '{}' has an area, asked at {} point{}{}", light->name, light->area.samples,
                            light->area.samples == 1 ? "" : "s", at(light->place)));
    }
    void nested_media() {
        if (scene_.notes_media) {
            add(Effect::nested_media, false, "media = \"notes\": outside of every medium is air");
            return;
        }
        for (const std::uint32_t object : world_.media.all()) {
            std::optional<std::uint32_t> neighbour;
            world_.media.each_near(object, [&](std::uint32_t other) {
                if (!neighbour) neighbour = other;
            });
            if (!neighbour) continue;
            if (!follows() && !needs(Effect::shadows))
                return add(Effect::nested_media, false, nothing_follows);
            add(Effect::nested_media, true,
                fmt::format("media '{}' and '{}' may share a place{}", title(object), title(*neighbour),
                            at(place_of(object))));
            return;
        }
        add(Effect::nested_media, false, "no two media come near each other");
    }
    void antialiasing() {
        if (scene_.camera.samples > 1)
            add(Effect::antialiasing, true,
                fmt::format("the camera asks for up to {} samples where neighbouring pixels differ{}",
                            scene_.camera.samples, at(scene_.samples_place)));
        else
            add(Effect::antialiasing, false, "the camera asks for one sample in each pixel");
    }

    static constexpr const char* nothing_follows = "max_depth is 0: no ray follows the eye's";
    static constexpr const char* no_answer = "no drawn material answers to a light";

    const Scene& scene_;
    const WorldBase& world_;
    std::vector<UsedMaterial> used_;
    std::vector<EffectNeed> needs_;
};

} // namespace

std::vector<EffectNeed> effect_needs(const Scene& scene, const WorldBase& world) {
    return Finder(scene, world).all();
}

EffectSet needed_effects(const std::vector<EffectNeed>& needs) {
    EffectSet set;
    for (const EffectNeed& need : needs) set.set(need.effect, need.needed);
    return set;
}

} // namespace rayscope
