#pragma once
// The steps of the tracer with all effects that the classic one does not have.

#include "core/tracer/tracer.hpp"

namespace rayscope {

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::shade_hit_with_effects(const Ray<T>& ray, Interaction<N> at,
                                                                       const Budget& budget, int tested) {
    if (budget.wavelength > 0) set_speeds(at, double(budget.wavelength));
    std::optional<EvenMaterials> even;
    if (at.material->patterns != none || at.wall->patterns != none) {
        even = even_materials(at, ray);
        at.material = &even->own;
        at.wall = &even->wall;
    }
    if constexpr (Recorder::enabled) record_boundary(ray, at);
    // What the medium on the ray's way leaves. The record tells of the light as it arrives at the ray's start.
    Colour passed{1};
    Budget dimmed = budget;
    if (world_.absorbs) {
        passed = absorbed(ray, budget.medium, at.hit.t);
        dimmed.weight *= passed;
    }
    Colour local = local_light<true>(at, dimmed);
    if (keeps_brought_) brought_.add(kind_, dimmed.weight * local);
    Colour colour = local;
    add_boundary_light_with_effects(colour, at, dimmed);
    if (world_.absorbs) {
        local *= passed;
        colour *= passed;
    }
    if constexpr (Recorder::enabled) recorder_.record(RayFinished{local, colour, tested});
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::add_boundary_light_with_effects(Colour& colour,
                                                                              const Interaction<N>& at,
                                                                              const Budget& budget) {
    const Material& material = *at.material;
    if (!material.transmits()) {
        add_boundary_light(colour, at, budget);
        return;
    }
    if (!(budget.wavelength > 0) && spreads(at.media)) {
        add_spread_light(colour, at, budget);
        return;
    }
    const Bend bend{bent_at(at, at.speed_from, at.speed_to), at.speed_from, at.speed_to,
                    double(budget.wavelength)};
    Shares shares{material.reflection, material.transmission};
    if (material.mirror != Mirror::constant) {
        shares.mirrored = Colour{reflected_share(material.mirror, bend)};
        shares.through = Colour{1} - shares.mirrored;
    }
    add_shared_light(colour, at, bend, shares, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::add_area_light(Colour& colour, Id id, const Interaction<N>& at,
                                                             const Budget& budget) {
    const Light& light = world_.lights[std::size_t(id)];
    const Vec3<T> to_centre = to_middle_of(light, at);
    LightPoint point{id, 0, light.area.samples, light.colour, light.directional};
    point.colour /= double(point.samples);
    int lit = 0;
    for (; point.sample < point.samples; ++point.sample) {
        const Colour light_of_point =
            light_along<true>(point, to_centre + aside(point, to_centre, budget), at, budget);
        lit += largest_component(light_of_point) > 0 ? 1 : 0;
        colour += light_of_point;
    }
    if (budget.depth == 0 && lit > 0 && lit < point.samples) seen_.penumbra = true;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::passing_with_effects(const Blocker<T>& blocker,
                                                                     const Ray<T>& ray,
                                                                     const Leaving<T>& leaving) {
    const Material& material = world_.material_of(blocker.object);
    const Solid<N>& solid = world_.solids[blocker.surface.solid];
    if (material.mirror != Mirror::constant) {
        const Hit<T> hit{blocker.t, blocker.object, blocker.surface, blocker.entering, false};
        const MediaPair media = media_at(world_, ray, hit, leaving, work_);
        const T around = T(world_.medium_speed), from = speed_in(world_, media.from),
                to = speed_in(world_, media.to);
        if (from == to) return Colour{1};
        // The ray is not bent. It leads where light in the open would; between flat walls that light runs in each medium
        // as if it had come right out of the open.
        const Vec3<T> normal = solid.normal(ray, blocker.t, blocker.surface.face);
        const auto within = refract<N>(ray.direction, normal, around, from);
        if (within.total()) return Colour{0};
        const auto bent = refract<N>(within.direction, normal, from, to);
        const T reflected = material.mirror == Mirror::schlick ? schlick(bent, from, to)
                                                               : fresnel<N>(bent, from, to).unpolarized();
        return Colour{1 - double(reflected)};
    }
    if (material.patterns != none)
        if (const auto& pattern = world_.patterns[std::size_t(material.patterns)].transmission)
            return pattern->at(pattern_point(solid, ray, blocker.t, int(blocker.surface.face)));
    return material.transmission;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
bool Tracer<N, Stage, Recorder, Order, mask>::spreads(const MediaPair& media) const {
    const auto dispersion = [&](Id medium) {
        return medium == none ? Dispersion{} : world_.material_of(std::uint32_t(medium)).dispersion;
    };
    const Dispersion from = dispersion(media.from), to = dispersion(media.to);
    // Between two media of the same kind no colour is bent.
    return (from.spreads() || to.spreads()) && from != to;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
auto Tracer<N, Stage, Recorder, Order, mask>::speed_at(Id medium, double wavelength) const -> T {
    return medium == none ? T(world_.medium_speed)
                          : T(world_.material_of(std::uint32_t(medium)).speed_at(wavelength));
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
auto Tracer<N, Stage, Recorder, Order, mask>::aside(const LightPoint& point, const Vec3<T>& to_centre,
                                                    const Budget& budget) const -> Vec3<T> {
    const std::uint32_t seed = mixed(mixed(budget.path, area_stream), std::uint32_t(point.id));
    return as<T>(world_.lights[std::size_t(point.id)].area.offset(
        hashed_sobol(std::uint32_t(point.sample), seed), as<double>(to_centre)));
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::set_speeds(Interaction<N>& at, double wavelength) const {
    at.speed_from = speed_at(at.media.from, wavelength);
    at.speed_to = speed_at(at.media.to, wavelength);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
EvenMaterials Tracer<N, Stage, Recorder, Order, mask>::even_materials(const Interaction<N>& at,
                                                                      const Ray<T>& ray) const {
    const Vec3d point =
        pattern_point(world_.solids[at.hit.surface.solid], ray, at.hit.t, int(at.hit.surface.face));
    const auto even = [&](const Material& material) {
        return material.patterns == none
                   ? material
                   : without_patterns(material, world_.patterns[std::size_t(material.patterns)], point);
    };
    return {even(*at.material), even(*at.wall)};
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
double Tracer<N, Stage, Recorder, Order, mask>::reflected_share(Mirror mirror, const Bend& bend) {
    const auto shares = fresnel<N>(bend.bent, bend.speed_from, bend.speed_to);
    const double by_schlick = double(schlick(bend.bent, bend.speed_from, bend.speed_to));
    const double reflected = mirror == Mirror::schlick ? by_schlick : double(shares.unpolarized());
    if constexpr (Recorder::enabled)
        recorder_.record(FresnelShared{double(shares.perpendicular), double(shares.parallel), by_schlick,
                                       reflected, bend.wavelength});
    return reflected;
}

// One ray has carried all colours so far. One still does on the mirrored way, which is the same for all of them.
template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::add_spread_light(Colour& colour, const Interaction<N>& at,
                                                               const Budget& budget) {
    const Material& material = *at.material;
    if (spectrum_.empty()) spectrum_.sample(world_.wavelengths, budget.path);
    struct Ray {
        Bend bend;
        Colour share;
    };
    std::vector<Ray> through;
    through.reserve(spectrum_.lines().size());
    Colour mirrored = material.mirror == Mirror::constant ? material.reflection : Colour{0};
    for (const Spectrum::Line& line : spectrum_.lines()) {
        const T from = speed_at(at.media.from, line.wavelength), to = speed_at(at.media.to, line.wavelength);
        const Bend bend{bent_at(at, from, to), from, to, line.wavelength};
        Colour share = material.transmission * line.share;
        if (bend.bent.total()) {
            mirrored += share;
            note_total_reflection(bend, share);
            refuse(RayKind::refracted, Reason::total_internal_reflection, share, budget);
            continue;
        }
        if (material.mirror != Mirror::constant) {
            const Colour reflected = share * reflected_share(material.mirror, bend);
            mirrored += reflected;
            share -= reflected;
        }
        through.push_back({bend, share});
    }
    colour += mirrored_light(at, mirrored, budget);
    for (const Ray& ray : through) colour += transmitted_light(at, ray.bend, ray.share, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::absorbed(const Ray<T>& ray, Id medium, T t) {
    if (medium == none) return Colour{1};
    const Material& material = world_.material_of(std::uint32_t(medium));
    if (!material.absorbs()) return Colour{1};
    const double way = double(t) * double(length(ray.direction));
    const Colour passed = beer_lambert(material.absorption, way);
    if constexpr (Recorder::enabled) recorder_.record(Absorbed{medium, way, passed});
    return passed;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::absorbed_to_light(const Ray<T>& ray, T distance,
                                                                  const Interaction<N>& at) {
    Colour seen{1};
    const auto take = [&](Id medium, double way, const Colour& passed) {
        if constexpr (Recorder::enabled) recorder_.record(Absorbed{medium, way, passed});
        seen *= passed;
    };
    if (world_.notes_media)
        AbsorbedWay<N>().walk_by_the_notes(world_, distance, at.media.from, work_.blockers, take);
    else
        AbsorbedWay<N>().walk(world_, ray, distance, at.back, work_, take);
    return seen;
}

} // namespace rayscope
