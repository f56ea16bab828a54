#pragma once
// Local light: what the lights send to a point, and what stands in their way.

#include "core/tracer/tracer.hpp"

namespace rayscope {

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
template <bool added>
Colour Tracer<N, Stage, Recorder, Order, mask>::local_light(const Interaction<N>& at, const Budget& budget) {
    if (at.leaves_transmitting_solid) {
        if constexpr (Recorder::enabled) recorder_.record(LocalLightSkipped{});
        return Colour{0};
    }
    if constexpr (Recorder::enabled) recorder_.record(AmbientLit{world_.ambient, at.wall->ambient});
    Colour colour = world_.ambient * at.wall->ambient;
    for (Id light = 0; light < Id(world_.lights.size()); ++light)
        add_light_from<added>(colour, light, at, budget);
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
template <bool added>
void Tracer<N, Stage, Recorder, Order, mask>::add_light_from(Colour& colour, Id id, const Interaction<N>& at,
                                                             const Budget& budget) {
    const Light& light = world_.lights[std::size_t(id)];
    if constexpr (added) {
        if (light.area.is_sampled()) {
            add_area_light(colour, id, at, budget);
            return;
        }
    }
    colour +=
        light_along<added>({id, 0, 1, light.colour, light.directional}, to_middle_of(light, at), at, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
template <bool added>
Colour Tracer<N, Stage, Recorder, Order, mask>::light_along(const LightPoint& light, const Vec3<T>& offset,
                                                            const Interaction<N>& at, const Budget& budget) {
    const Vec3<T> to_light = normalized(offset);
    double cosine = double(dot(at.facing, to_light));
    // Light from behind the face itself does not come through, whatever an interpolated normal says.
    if (const double flat = double(dot(at.flat, to_light)); at.smooth && flat < 0)
        cosine = minimum(cosine, flat);
    const Colour diffuse = at.wall->diffuse * diffuse_share(cosine);
    // The highlight takes longest: where it decides nothing, it waits until the light is known to arrive.
    const bool waits = !Recorder::enabled && largest_component(diffuse) > 0;
    Colour specular = waits ? Colour{0} : highlight(to_light, cosine, at);
    // A light behind the surface, or one that the material ignores, needs no shadow ray.
    Colour seen{1};
    if (world_.lights[std::size_t(light.id)].shadows && largest_component(diffuse + specular) > 0)
        seen = visibility<added>(light, to_light, light.endless ? infinity<T> : length(offset), at, budget);
    if (waits && seen != Colour{0}) specular = highlight(to_light, cosine, at);
    const Colour arriving = light.colour * seen;
    if constexpr (Recorder::enabled)
        recorder_.record(LightLit{light.id, as<double>(to_light), cosine,
                                  double(mirror_cosine(to_light, at.facing, at.incoming)), at.wall->shininess,
                                  light.sample, light.samples, light.colour, seen, at.wall->diffuse,
                                  at.wall->specular, diffuse * arriving, specular * arriving});
    return diffuse * arriving + specular * arriving;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
template <bool added>
Colour Tracer<N, Stage, Recorder, Order, mask>::visibility(const LightPoint& light, const Vec3<T>& to_light,
                                                           T distance, const Interaction<N>& at,
                                                           const Budget& budget) {
    const Ray<T> ray{at.point, to_light};
    ++work_.counters.rays[std::size_t(RayKind::shadow)];
    if constexpr (Recorder::enabled)
        recorder_.record(spawned(RayKind::shadow, ray, at.back, budget, distance, light.id));
    const std::uint64_t before = work_.counters.objects;
    // A stage's lists are made for the middle of a light.
    const bool is_point = !world_.lights[std::size_t(light.id)].area.is_sampled();
    const RayUse use{RayKind::shadow, none, none, is_point ? light.id : none};
    const bool dark =
        stage_.blocked(use, ray, Range<T>{secondary_start<N>, distance}, at.back, work_, recorder_);
    const int tested = int(work_.counters.objects - before);
    Colour seen{dark ? 0.0 : 1.0};
    if (!dark) {
        for (const Blocker<T>& blocker : work_.blockers) {
            Colour transmission = world_.material_of(blocker.object).transmission;
            if constexpr (added) transmission = passing_with_effects(blocker, ray, at.back);
            if constexpr (Recorder::enabled)
                recorder_.record(BlockerPassed{Id(blocker.object), double(blocker.t), transmission});
            seen *= transmission;
        }
        if constexpr (added)
            if (world_.absorbs && largest_component(seen) > 0) seen *= absorbed_to_light(ray, distance, at);
    }
    if constexpr (Recorder::enabled) recorder_.record(RayFinished{seen, seen, tested});
    return seen;
}

} // namespace rayscope
