#include "visualizer/window/scene_edit.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace rayscope::window {
namespace {

Colour* colour_of(SceneMaterial& material, MaterialPart part) {
    switch (part) {
    case MaterialPart::ambient: return &material.ambient;
    case MaterialPart::diffuse: return &material.diffuse;
    case MaterialPart::specular: return &material.specular;
    case MaterialPart::reflection: return &material.reflection;
    case MaterialPart::transmission: return &material.transmission;
    default: return nullptr;
    }
}

} // namespace

double part_of(const SceneMaterial& material, MaterialPart part) {
    SceneMaterial copy = material;
    if (const Colour* colour = colour_of(copy, part)) return largest_component(*colour);
    return part == MaterialPart::shininess ? material.shininess : 1 / material.speed;
}

double range_of(MaterialPart part) {
    return part == MaterialPart::shininess ? 500 : part == MaterialPart::index ? 3 : 1;
}

double most_of(const SceneMaterial& material, MaterialPart part) {
    switch (part) {
    case MaterialPart::reflection: return std::max(0.0, 1 - largest_component(material.transmission));
    case MaterialPart::transmission: return std::max(0.0, 1 - largest_component(material.reflection));
    default: return range_of(part);
    }
}

bool is_patterned(const SceneMaterial& material, MaterialPart part) {
    const Patterns& patterns = material.patterns;
    switch (part) {
    case MaterialPart::ambient: return patterns.ambient.has_value();
    case MaterialPart::diffuse: return patterns.diffuse.has_value();
    case MaterialPart::specular: return patterns.specular.has_value();
    case MaterialPart::reflection: return patterns.reflection.has_value();
    case MaterialPart::transmission: return patterns.transmission.has_value();
    default: return false;
    }
}

std::string set_part(SceneMaterial& material, MaterialPart part, double value) {
    if (Colour* colour = colour_of(material, part)) {
        const double before = largest_component(*colour);
        *colour = before > 0 ? *colour * (value / before) : Colour{value};
        // What the file says and what is shown are the same number.
        for (int i = 0; i < 3; ++i) (*colour)[i] = std::round((*colour)[i] * 1e6) / 1e6;
        const bool grey = colour->r == colour->g && colour->g == colour->b;
        return grey ? toml_number(colour->r) : toml_vector(*colour);
    }
    if (part == MaterialPart::shininess)
        material.shininess = value;
    else
        material.speed = 1 / value;
    return toml_number(value);
}

std::string toml_number(double number) {
    std::array<char, 40> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number).ptr;
    return std::string(buffer.data(), std::size_t(end - buffer.data()));
}

Vec3d rounded(const Vec3d& v, double step) {
    const double power = std::pow(10.0, std::abs(std::ceil(-std::log10(step))));
    Vec3d result;
    for (int i = 0; i < 3; ++i) // dividing by a power of ten gives the decimal's own double
        result[i] = step < 1 ? std::round(v[i] * power) / power : std::round(v[i] / power) * power;
    return result + Vec3d{0}; // no −0
}

double tidy(double sum) {
    constexpr int digits = 15;
    std::array<char, 40> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, sum);
    return std::strtod(buffer.data(), nullptr);
}

std::string toml_vector(const Vec3d& v) {
    std::string text = "[";
    for (int i = 0; i < 3; ++i) text.append(i > 0 ? ", " : "").append(toml_number(v[i]));
    return text.append("]");
}

} // namespace rayscope::window
