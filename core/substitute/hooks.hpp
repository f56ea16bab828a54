#pragma once
// Where formulas of somebody else's come into the tracer's way: specializations for the numbers Substituted of what the
// tracer asks. Included before whatever uses them.

#include "core/math/substituted.hpp"
#include "core/reflection/mirror.hpp"
#include "core/refraction/fresnel.hpp"
#include "core/refraction/snell.hpp"
#include "core/stage/record_object.hpp"
#include "core/substitute/formulas.hpp"
#include "core/tracer/interaction.hpp"
#include "core/world/inside_list.hpp"

namespace rayscope {

/// The formulas in use, and of the hit that is being shaded: its place, where the last normal was asked for, and what a
/// formula said of its wall.
struct FormulasInUse {
    const Formulas* formulas = nullptr;
    Vec3d hit_point{0};
    std::optional<FormulaWall> wall;
};
[[nodiscard]] FormulasInUse& formulas_in_use();

template <>
[[nodiscard]] inline Vec3<double> mirrored<Substituted, double>(const Vec3<double>& d,
                                                                const Vec3<double>& n) {
    const FormulasInUse& use = formulas_in_use();
    return use.formulas->mirror ? use.formulas->mirror(use.hit_point, d, n) : mirrored<double>(d, n);
}

template <>
[[nodiscard]] inline Refraction<double> refract<Substituted, double>(Vec3<double> d, Vec3<double> n,
                                                                     double speed_from, double speed_to) {
    Refraction<double> bent = refract<double>(d, n, speed_from, speed_to);
    const FormulasInUse& use = formulas_in_use();
    // Whether there is a ray at all is the formula's to say.
    const auto set_total = [&](bool total) {
        bent.radicand = total ? minimum(bent.radicand, -1.0) : maximum(bent.radicand, 0.0);
    };
    if (use.wall) set_total(use.wall->total);
    d = normalized(d);
    n = normalized(n);
    // The lesson's formula trusts the normal. Ours would turn it, and hide that it was not against the ray.
    if (use.wall && dot(n, d) > 0 && !bent.total())
        bent.direction = normalized(bent.eta * d - (bent.eta * dot(n, d) + sqrt(bent.radicand)) * n);
    if (!use.formulas->refract) return bent;
    const auto direction = use.formulas->refract(d, dot(n, d) > 0 ? -n : n, speed_from, speed_to);
    set_total(!direction);
    if (direction) bent.direction = *direction;
    return bent;
}

template <>
[[nodiscard]] inline Reflectance<double> fresnel<Substituted, double>(const Refraction<double>& bent,
                                                                      double speed_from, double speed_to) {
    const Formulas& formulas = *formulas_in_use().formulas;
    if (!formulas.fresnel) return fresnel<double>(bent, speed_from, speed_to);
    const double reflected = formulas.fresnel(speed_from, speed_to, bent.cosine);
    if (reflected < epsilon<double>) return {0, 0}; // rounding alone sends no ray
    return {reflected, reflected};
}

template <> void reconsider_wall<Substituted>(const World<Substituted>& world, Interaction<Substituted>& at);

template <> Vec3<double> Solid<Substituted>::normal(const Ray<double>& ray, double t, int face) const;
template <> inline auto Solid<Substituted>::place(const Ray<double>& ray, double t, int face) const -> Place {
    return {normal(ray, t, face), error_bound(ray, t, face)};
}
template <> Intervals<double> Solid<Substituted>::intervals(const Ray<double>& ray, int leaving) const;
template <> Intervals<double> Sphere<Substituted>::intervals(const Ray<double>& ray, int leaving) const;
template <>
std::span<const Crossing<double>>
crossings<Substituted, double>(const World<Substituted>& world, std::uint32_t object, const Ray<double>& ray,
                               const LeavingSurface<double>* leaving, Work<double>& work);

template <>
void record_object<Substituted, double>(const World<Substituted>& world, std::uint32_t object,
                                        const Ray<double>& ray, const Range<double>& range,
                                        const LeavingSurface<double>* leaving, bool tests_parts,
                                        TraceRecorder& recorder);

} // namespace rayscope
