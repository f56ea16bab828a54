#include "core/effects/change_effects.hpp"

#include "core/effects/used_materials.hpp"
#include "core/scene/wording.hpp"

#include <stdexcept>

namespace rayscope {
namespace {

constexpr int added_samples = 16;
constexpr double added_coefficient = 0.2, added_abbe_number = 30, added_index = 1.5;
// Of the distance between the eye and what it looks at.
constexpr double added_pattern_size = 0.05, added_light_radius = 0.05, added_absorption_length = 0.2;

double view_length(const Scene& scene) {
    const double distance = length(scene.camera.look_at - scene.camera.eye);
    return distance > 0 ? distance : 1;
}

/// Of light that comes straight on, from what fills the space between the solids.
/// @param around its speed there
void with_constant_shares(SceneMaterial& material, double around) {
    if (material.mirror == Mirror::constant) return;
    const double contrast = (around - material.speed) / (around + material.speed);
    material.mirror = Mirror::constant;
    material.reflection = Colour{contrast * contrast};
    material.transmission = Colour{1} - material.reflection;
}

void set_even(Colour& colour, std::optional<Pattern>& pattern, const Colour& value) {
    colour = value;
    pattern.reset();
}

void take_from(Effect effect, SceneMaterial& m, double around) {
    switch (effect) {
    case Effect::ambient: set_even(m.ambient, m.patterns.ambient, Colour{0}); break;
    case Effect::diffuse: set_even(m.diffuse, m.patterns.diffuse, Colour{0}); break;
    case Effect::specular: set_even(m.specular, m.patterns.specular, Colour{0}); break;
    case Effect::reflection:
        with_constant_shares(m, around);
        set_even(m.reflection, m.patterns.reflection, Colour{0});
        break;
    case Effect::refraction:
        with_constant_shares(m, around);
        set_even(m.transmission, m.patterns.transmission, Colour{0});
        break;
    case Effect::fresnel: with_constant_shares(m, around); break;
    case Effect::absorption: m.absorption = Colour{0}; break;
    case Effect::dispersion: m.dispersion = {}; break;
    case Effect::patterns: m.patterns = {}; break; // the colours hold their means
    default: break;
    }
}

/// @return whether anything was changed
bool add_to(Effect effect, SceneMaterial& m, double size) {
    const auto add = [](Colour& colour, std::optional<Pattern>& pattern) {
        set_even(colour, pattern, Colour{added_coefficient});
        return true;
    };
    const auto has_room_beside = [](const Colour& colour, const std::optional<Pattern>& pattern) {
        return !(largest_component(largest_of(colour, pattern)) > 1 - added_coefficient);
    };
    switch (effect) {
    case Effect::ambient: return add(m.ambient, m.patterns.ambient);
    case Effect::diffuse: return add(m.diffuse, m.patterns.diffuse);
    case Effect::specular: return add(m.specular, m.patterns.specular);
    case Effect::reflection:
        return m.mirror == Mirror::constant && has_room_beside(m.transmission, m.patterns.transmission) &&
               add(m.reflection, m.patterns.reflection);
    case Effect::refraction:
        if (!has_room_beside(m.reflection, m.patterns.reflection)) return false;
        m.speed = 1 / added_index;
        return add(m.transmission, m.patterns.transmission);
    case Effect::fresnel:
        if (!m.transmits()) return false;
        m.mirror = Mirror::fresnel;
        m.patterns.reflection.reset();
        m.patterns.transmission.reset();
        return true;
    case Effect::absorption:
        if (!m.transmits()) return false;
        m.absorption = Colour{1 / (added_absorption_length * size)};
        return true;
    case Effect::dispersion:
        if (!m.transmits() || m.speed == 1) return false;
        m.dispersion = Dispersion::by_abbe_number(1 / m.speed, added_abbe_number);
        return true;
    case Effect::patterns:
        if (!(largest_component(m.diffuse) > 0)) return false;
        m.patterns.diffuse =
            Pattern{Pattern::Kind::checker, m.diffuse, m.diffuse / 2.0, added_pattern_size * size, 0};
        return true;
    default: return false;
    }
}

bool give_area(SceneLight& light, const Scene& scene) {
    if (light.directional) return false;
    const double distance = length(light.position - scene.camera.look_at);
    if (!(distance > 0)) return false;
    light.area.shape = LightArea::Shape::sphere;
    light.area.radius = added_light_radius * distance;
    light.area.samples = added_samples;
    return true;
}

EffectSet all_effects() {
    EffectSet all;
    for (std::size_t i = 0; i < effect_names.size(); ++i) all.set(Effect(i));
    return all;
}

Effect effect_called(std::string_view name) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        if (effect_names[i].name == name) return Effect(i);
        names.push_back(effect_names[i].name);
    }
    throw std::invalid_argument(
        "expected auto, all, or a list of effects, each with + or - before it or none of them: " +
        one_of(names) + "; found " + in_quotes(name) + did_you_mean(name, names));
}

} // namespace

void take_away(Effect effect, Scene& scene) {
    for (SceneMaterial& material : scene.materials) take_from(effect, material, scene.medium_speed);
    for (SceneLight& light : scene.lights) {
        if (effect == Effect::shadows) light.shadows = false;
        if (effect == Effect::soft_shadows) light.area = {};
    }
    if (effect == Effect::ambient) scene.ambient = Colour{0};
    if (effect == Effect::nested_media) scene.notes_media = true;
    if (effect == Effect::antialiasing) scene.camera.samples = 1;
}

bool add_effect(Effect effect, Scene& scene) {
    bool added = false;
    if (effect == Effect::ambient && !(largest_component(scene.ambient) > 0)) scene.ambient = Colour{1};
    for (const UsedMaterial& used : used_materials(scene))
        if (used.is_object && add_to(effect, scene.materials[used.material], view_length(scene)))
            added = true;
    for (SceneLight& light : scene.lights) {
        if (!light.shines()) continue;
        if (effect == Effect::shadows) added = light.shadows = true;
        if (effect == Effect::soft_shadows && give_area(light, scene)) added = true;
    }
    if (effect == Effect::nested_media && scene.notes_media) {
        scene.notes_media = false;
        added = true;
    }
    if (effect == Effect::antialiasing) {
        scene.camera.samples = added_samples;
        scene.samples_place = {};
        added = true;
    }
    return added;
}

Scene with_effects(Scene scene, const EffectSet& needed, const EffectSet& wanted) {
    for (std::size_t i = 0; i < effect_names.size(); ++i)
        if (const auto effect = Effect(i); needed.has(effect) && !wanted.has(effect))
            take_away(effect, scene);
    for (std::size_t i = 0; i < effect_names.size(); ++i)
        if (const auto effect = Effect(i); !needed.has(effect) && wanted.has(effect))
            (void)add_effect(effect, scene);
    return scene;
}

EffectSet parse_effects(std::string_view text, const EffectSet& needed) {
    if (text == "auto") return needed;
    if (text == "all") return all_effects();
    const bool changes = text.starts_with('+') || text.starts_with('-');
    EffectSet set = changes ? needed : EffectSet();
    while (true) {
        const std::size_t comma = text.find(',');
        std::string_view word = text.substr(0, comma);
        const bool on = !word.starts_with('-');
        if ((word.starts_with('+') || word.starts_with('-')) != changes)
            throw std::invalid_argument("expected + or - before each effect, or before none; found " +
                                        in_quotes(word));
        if (changes) word.remove_prefix(1);
        set.set(effect_called(word), on);
        if (comma == std::string_view::npos) return set;
        text.remove_prefix(comma + 1);
    }
}

} // namespace rayscope
