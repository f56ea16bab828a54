#pragma once
// Where formulas of somebody else's come into the tracer's way: specializations for the numbers Substituted of what the
// tracer asks. Included before whatever uses them.

#include "core/math/substituted.hpp"
#include "core/reflection/mirror.hpp"
#include "core/refraction/snell.hpp"
#include "core/stage/record_object.hpp"
#include "core/substitute/formulas.hpp"
#include "core/world/inside_list.hpp"

namespace rayscope {

/// The formulas in use, and the place where the last normal was asked for: the hit that is being shaded.
struct FormulasInUse {
    const Formulas* formulas = nullptr;
    Vec3d hit_point{0};
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
    const Formulas& formulas = *formulas_in_use().formulas;
    if (!formulas.refract) return bent;
    d = normalized(d);
    n = normalized(n);
    const auto direction = formulas.refract(d, dot(n, d) > 0 ? -n : n, speed_from, speed_to);
    // Whether there is a ray at all is the formula's to say.
    if (!direction)
        bent.radicand = minimum(bent.radicand, -1.0);
    else
        bent.radicand = maximum(bent.radicand, 0.0);
    if (direction) bent.direction = *direction;
    return bent;
}

template <> Vec3<double> Solid<Substituted>::normal(const Ray<double>& ray, double t, int face) const;
template <> inline auto Solid<Substituted>::place(const Ray<double>& ray, double t, int face) const -> Place {
    return {normal(ray, t, face), error_bound(ray, t, face)};
}
template <> Intervals<double> Sphere<Substituted>::intervals(const Ray<double>& ray, int leaving) const;
template <>
std::span<const Crossing<double>>
crossings<Substituted, double>(const World<Substituted>& world, std::uint32_t object, const Ray<double>& ray,
                               const LeavingSurface<double>* leaving, Work<double>& work);

template <>
void record_object<Substituted, double>(const World<Substituted>& world, std::uint32_t object,
                                        const Ray<double>& ray, const Range<double>& range,
                                        const LeavingSurface<double>* leaving, TraceRecorder& recorder);

} // namespace rayscope
