#include "core/scene/toml_optics.hpp"

#include "core/scene/wording.hpp"

#include <fmt/format.h>

namespace rayscope {
namespace {

constexpr Bounds possible_index{1 / 1e6, 1e6};
constexpr Bounds length_bounds{1e-100, 1e100};

// The index must have a meaning for every wavelength that is sampled.
void check_index(const TomlValue& blamed, const Dispersion& dispersion) {
    if (const auto pole = dispersion.pole())
        blamed.fail(
            fmt::format("a term of the formula is infinite at {:.6g} nm: expected √C outside of {} to {} nm",
                        *pole, shortest_wavelength, longest_wavelength));
    constexpr int places = 1024;
    for (int i = 0; i <= places; ++i) {
        const double wavelength =
            shortest_wavelength + (longest_wavelength - shortest_wavelength) * i / places;
        const double index = dispersion.index(wavelength);
        if (!(index >= possible_index.min && index <= possible_index.max))
            blamed.fail(fmt::format("the index of refraction is {:.6g} at {:.6g} nm, expected from {} to {}",
                                    index, wavelength, possible_index.min, possible_index.max));
    }
}

void set_dispersion(const TomlValue& blamed, const Dispersion& dispersion, SceneMaterial& material) {
    check_index(blamed, dispersion);
    material.dispersion = dispersion;
    material.speed = 1 / dispersion.index(line_d);
}

Dispersion formula_of(const TomlValue& value, Dispersion::Formula formula, std::size_t least,
                      std::size_t most, std::string_view shape) {
    const auto numbers = value.list();
    if (numbers.size() < least || numbers.size() > most)
        value.fail(fmt::format("expected {}, found {} numbers", shape, numbers.size()));
    Dispersion dispersion;
    dispersion.formula = formula;
    for (std::size_t i = 0; i < numbers.size(); ++i) dispersion.coefficients[i] = numbers[i].number();
    return dispersion;
}

void read_dispersion(const TomlTable& table, SceneMaterial& material) {
    constexpr std::array<std::string_view, 3> formulas{"abbe", "cauchy", "sellmeier"};
    for (std::size_t i = 0; i < formulas.size(); ++i)
        for (std::size_t j = i + 1; j < formulas.size(); ++j) table.allow_one(formulas[i], formulas[j]);
    for (const std::string_view formula : {"cauchy", "sellmeier"})
        for (const std::string_view constant : {"speed", "index"}) table.allow_one(constant, formula);

    if (const auto abbe = table.find("abbe")) {
        if (!table.has("index") && !table.has("speed"))
            abbe->fail("'abbe' says how the index depends on the colour: expected 'index' beside it, for "
                       "example index = 1.5168");
        set_dispersion(*abbe, Dispersion::by_abbe_number(1 / material.speed, abbe->number({0, 1e6, true})),
                       material);
    }
    if (const auto cauchy = table.find("cauchy"))
        set_dispersion(*cauchy, formula_of(*cauchy, Dispersion::Formula::cauchy, 2, 3, "[A, B] or [A, B, C]"),
                       material);
    if (const auto sellmeier = table.find("sellmeier"))
        set_dispersion(
            *sellmeier,
            formula_of(*sellmeier, Dispersion::Formula::sellmeier, 6, 6, "[B1, B2, B3, C1, C2, C3]"),
            material);
}

} // namespace

void read_optics(const TomlTable& table, SceneMaterial& material) {
    if (const auto fresnel = table.find("fresnel")) {
        if (fresnel->is_string())
            material.mirror = fresnel->choice({"exact", "schlick"}) == 0 ? Mirror::fresnel : Mirror::schlick;
        else if (fresnel->boolean())
            material.mirror = Mirror::fresnel;
        if (material.mirror != Mirror::constant)
            for (const std::string_view coefficient : {"reflection", "transmission"})
                if (const auto forbidden = table.find(coefficient))
                    forbidden->fail(fmt::format("'{}': with fresnel the angle says what is reflected, and "
                                                "the rest goes through; leave "
                                                "the coefficient out",
                                                coefficient));
    }
    if (const auto absorption = table.find("absorption"))
        material.absorption = absorption->colour(not_negative);
    read_dispersion(table, material);
}

void read_coefficient(const TomlValue& value, const Bounds& bounds, Colour& colour,
                      std::optional<Pattern>& pattern) {
    if (!value.is_table()) {
        colour = value.colour(bounds);
        return;
    }
    const TomlTable table = value.table();
    table.allow_only("a pattern", {"checker", "stripes", "size", "axis"});
    table.allow_one("checker", "stripes");
    Pattern read;
    read.kind = table.has("stripes") ? Pattern::Kind::stripes : Pattern::Kind::checker;
    const TomlValue colours = table.has("stripes")
                                  ? *table.find("stripes")
                                  : table.require("checker", value.place(), "checker = [1, 0], size = 0.5");
    const auto two = colours.list(2, "two colours");
    read.even = two[0].colour(bounds);
    read.odd = two[1].colour(bounds);
    if (const auto size = table.find("size")) read.size = size->number(length_bounds);
    if (const auto axis = table.find("axis")) {
        if (read.kind != Pattern::Kind::stripes) axis->fail("'axis': a checker has none, stripes do");
        read.axis = int(axis->choice({"x", "y", "z"}));
    }
    // For what does not look at the place.
    colour = (read.even + read.odd) / 2.0;
    pattern = read;
}

void read_area(const TomlTable& table, SceneLight& light) {
    table.allow_one("sphere", "disk");
    table.allow_one("sphere", "rectangle");
    table.allow_one("disk", "rectangle");
    const auto shape = table.find("sphere") ? table.find("sphere")
                       : table.find("disk") ? table.find("disk")
                                            : table.find("rectangle");
    for (const std::string_view key : {"samples", "facing"})
        if (const auto value = table.find(key); value && !shape)
            value->fail(fmt::format(
                "'{}': a point has none; expected 'sphere', 'disk' or 'rectangle' beside it", key));
    if (!shape) return;
    if (light.directional) shape->fail("a light with a direction has no place, and so no area");
    LightArea& area = light.area;
    if (table.has("rectangle")) {
        const auto sides = shape->list(2, "two vectors from its centre to the middle of two edges");
        area.shape = LightArea::Shape::rectangle;
        area.u = sides[0].vector();
        area.v = sides[1].vector();
        if (length(cross(area.u, area.v)) == 0) shape->fail("'rectangle': the two vectors span no area");
    } else {
        area.shape = table.has("disk") ? LightArea::Shape::disk : LightArea::Shape::sphere;
        area.radius = shape->number(length_bounds);
    }
    const auto facing = table.find("facing");
    if (area.shape == LightArea::Shape::disk) {
        const Vec3d normal = table.require("facing", shape->place(), "facing = [0, 0, -1]").vector();
        if (length(normal) == 0) facing->fail("'facing' has length zero");
        area.u = across(normalized(normal));
        area.v = cross(normalized(normal), area.u);
    } else if (facing) {
        facing->fail("'facing': only a disk needs to say it");
    }
    constexpr int usual_samples = 16;
    const auto samples = table.find("samples");
    area.samples = samples ? samples->integer(1, most_samples) : usual_samples;
}

std::optional<EffectSet> read_effects(const TomlValue& value) {
    if (value.is_string()) {
        std::ignore = value.choice({"auto"});
        return std::nullopt;
    }
    std::vector<std::string_view> names;
    for (const EffectName& effect : effect_names) names.push_back(effect.name);
    EffectSet effects;
    for (const TomlValue& name : value.list()) effects.set(Effect(name.choice(names)));
    return effects;
}

} // namespace rayscope
