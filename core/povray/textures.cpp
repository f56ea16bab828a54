#include "core/povray/textures.hpp"

#include "core/povray/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace rayscope::povray {
namespace {

// POV-Ray multiplies ambient and diffuse light by one pigment.
struct Paint {
    Colour pigment{1}, ambient{0};
    double diffuse = 0;
};

Paint paint_of(const SceneMaterial& wall) {
    // So little of a pigment that its diffuse light is not seen; it lets the ambient light through.
    constexpr double trace = 1.0 / 65536;
    Paint paint;
    paint.diffuse = largest_component(wall.diffuse);
    if (paint.diffuse > 0) paint.pigment = wall.diffuse / paint.diffuse;
    for (int i = 0; i < 3; ++i) {
        if (paint.pigment[i] == 0 && wall.ambient[i] > 0) paint.pigment[i] = trace;
        if (wall.ambient[i] > 0) paint.ambient[i] = wall.ambient[i] / paint.pigment[i];
    }
    return paint;
}

std::string highlight(const SceneMaterial& wall) {
    const Colour& s = wall.specular;
    if (!(largest_component(s) > 0)) return "";
    return fmt::format(" phong {} phong_size {}",
                       number(s.x == s.y && s.y == s.z ? s.x : (s.x + s.y + s.z) / 3),
                       number(wall.shininess));
}

std::string mirror(const SceneMaterial& object) {
    if (object.mirror != Mirror::constant) return " reflection { 0, 1 fresnel on } conserve_energy";
    if (!(largest_component(object.reflection) > 0)) return "";
    return fmt::format(" reflection {{ {} }}", colour(object.reflection));
}

std::string opaque(const SceneMaterial& object, const SceneMaterial& wall) {
    const Paint paint = paint_of(wall);
    return fmt::format("texture {{\n  pigment {{ {} }}\n  finish {{ ambient {} diffuse {}{}{} }}\n}}\n",
                       colour(paint.pigment), colour(paint.ambient), number(paint.diffuse), highlight(wall),
                       mirror(object));
}

// What stands within "texture { … }".
std::string within(const std::string& texture) {
    const std::size_t begin = texture.find('{') + 1, end = texture.rfind('}');
    return texture.substr(begin, end - begin);
}

// Lets the colour through, and nothing else.
std::string filter(const Colour& transmission, const std::string& finish) {
    return fmt::format(
        "texture {{\n  pigment {{ rgbf <{}, {}, {}, 1> }}\n  finish {{ ambient 0 diffuse 0{} }}\n}}\n",
        number(transmission.x), number(transmission.y), number(transmission.z), finish);
}

// Two layers, the upper one last: paint that covers one half, and a filter that makes good for it. In one layer the
// paint would get darker as the transmission nears 1, and could not have a colour of its own.
std::string transparent(const SceneMaterial& object, const SceneMaterial& wall) {
    const Paint paint = paint_of(wall);
    const std::string shine = highlight(wall) + mirror(object);
    if (!(paint.diffuse > 0) && !(largest_component(paint.ambient) > 0))
        return filter(object.transmission, shine);
    const Colour& p = paint.pigment;
    return filter(2.0 * object.transmission, "") +
           fmt::format("texture {{\n  pigment {{ rgbt <{}, {}, {}, 0.5> }}\n  finish {{ ambient {} diffuse "
                       "{}{} }}\n}}\n",
                       number(p.x), number(p.y), number(p.z), colour(2.0 * paint.ambient),
                       number(2 * paint.diffuse), shine);
}

/// All patterns that show on a wall; the first one tells of the cells.
std::vector<const Pattern*> patterns_of(const SceneMaterial& object, const SceneMaterial& wall) {
    std::vector<const Pattern*> list;
    for (const auto* pattern : {&wall.patterns.ambient, &wall.patterns.diffuse, &wall.patterns.specular,
                                &object.patterns.reflection, &object.patterns.transmission})
        if (*pattern) list.push_back(&**pattern);
    return list;
}

SceneMaterial half_of(SceneMaterial material, bool even) {
    const auto put = [&](Colour& colour, const std::optional<Pattern>& pattern) {
        if (pattern) colour = even ? pattern->even : pattern->odd;
    };
    put(material.ambient, material.patterns.ambient);
    put(material.diffuse, material.patterns.diffuse);
    put(material.specular, material.patterns.specular);
    put(material.reflection, material.patterns.reflection);
    return material;
}

} // namespace

bool Textures::shows_patterns(std::size_t object, std::size_t wall) const {
    const SceneMaterial &o = scene_.materials[object], &w = scene_.materials[wall];
    const auto patterns = patterns_of(o, w);
    if (patterns.empty() || o.transmits()) return false;
    const Pattern& first = *patterns.front();
    return std::ranges::all_of(patterns, [&](const Pattern* p) { return p->has_cells_of(first); });
}

bool Textures::loses_patterns(std::size_t object, std::size_t wall) const {
    return !patterns_of(scene_.materials[object], scene_.materials[wall]).empty() &&
           !shows_patterns(object, wall);
}

std::string Textures::patterned(std::size_t object, std::size_t wall, const Mat4d& place) const {
    const SceneMaterial &o = scene_.materials[object], &w = scene_.materials[wall];
    const Pattern& cells = *patterns_of(o, w).front();
    const std::string even = opaque(half_of(o, true), half_of(w, true)),
                      odd = opaque(half_of(o, false), half_of(w, false));
    // A face at 0 belongs to the cells below it.
    constexpr double aside = 1.0 / 4096;
    const std::string size = number(cells.size);
    std::string text;
    if (cells.kind == Pattern::Kind::checker)
        text = fmt::format("checker\n{}{} translate {} scale {}", even, odd, number(aside), size);
    else
        text = fmt::format("gradient {} texture_map {{ [0.5 {}] [0.5 {}] }} translate {} scale {}",
                           std::string(1, "xyz"[cells.axis]), within(even), within(odd), number(aside),
                           number(2 * cells.size));
    return fmt::format("texture {{ {}{} }}", text, place == Mat4d{1} ? "" : " " + matrix(place));
}

std::string Textures::use(std::size_t object, std::size_t wall, bool has_volume, const Mat4d& place) {
    return shows_patterns(object, wall) ? patterned(object, wall, place) : use(object, wall, has_volume);
}

std::string Textures::use(std::size_t object, std::size_t wall, bool has_volume) {
    SceneMaterial o = scene_.materials[object];
    const SceneMaterial& w = scene_.materials[wall];
    const bool transmits = o.transmits();
    if (o.mirror != Mirror::constant) o.transmission = Colour{1}; // less what is mirrored
    const auto [at, is_new] = numbers_.try_emplace({object, wall}, numbers_.size() + 1);
    const std::size_t n = at->second;
    if (is_new) {
        declarations_ += '\n' + comment(object == wall ? o.name : o.name + ", lit like " + w.name);
        declarations_ +=
            fmt::format("#declare Material_{} =\n{}", n, transmits ? transparent(o, w) : opaque(o, w));
        if (transmits)
            declarations_ += fmt::format("#declare Inside_{} =\n{}", n, filter(o.transmission, mirror(o)));
    }
    std::string text = fmt::format("texture {{ Material_{} }}", n);
    // Our inner walls of what transmits have no light of their own.
    if (transmits && has_volume) text += fmt::format(" interior_texture {{ Inside_{} }}", n);
    return text;
}

} // namespace rayscope::povray
