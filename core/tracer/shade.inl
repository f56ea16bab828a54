#pragma once
// The tracer's steps, in the order in which light is gathered: what is hit, what lights it, what it mirrors, what it
// lets through.

#include "core/tracer/tracer.hpp"

namespace rayscope {

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::trace(const Ray<T>& ray, const RayUse& use,
                                                      std::uint32_t seed) {
    rays_left_ = world_.max_rays;
    deepest_ = 0;
    dropped_ = Colour{0};
    const Leaving<T> nothing;
    Budget budget;
    bool needs_medium = Recorder::enabled;
    if constexpr (all_effects) {
        if (adds_) {
            budget.path = seed;
            seen_ = {};
            brought_.clear();
            kind_ = RayKind::eye;
            spectrum_.clear();
            needs_medium = needs_medium || world_.absorbs;
        }
    }
    ++work_.counters.rays[std::size_t(RayKind::eye)];
    if (needs_medium) {
        work_.tests_parts = stage_.tests_parts(use);
        budget.medium = medium_at_start(world_, ray, work_);
    }
    if constexpr (Recorder::enabled) recorder_.record(spawned(RayKind::eye, ray, nothing, budget));
    Colour colour = shade(use, ray, nothing, budget);
    if constexpr (Order::waits) colour += follow_waiting();
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::shade(const RayUse& use, const Ray<T>& ray,
                                                      const Leaving<T>& leaving, const Budget& budget) {
    deepest_ = std::max(deepest_, budget.depth);
    const std::uint64_t before = work_.counters.objects;
    const Range<T> range{budget.depth == 0 ? T(0) : secondary_start<N>};
    const auto hit = stage_.closest(use, ray, range, leaving, work_, recorder_);
    const int tested = int(work_.counters.objects - before);
    if (!hit) {
        Colour background = world_.background;
        if constexpr (Recorder::enabled) recorder_.record(Missed{background});
        if constexpr (all_effects) {
            if (adds_) {
                if (world_.absorbs) background *= absorbed(ray, budget.medium, infinity<T>);
                if (keeps_brought_) brought_.add(kind_, budget.weight * background);
            }
        }
        if constexpr (Recorder::enabled) recorder_.record(RayFinished{background, background, tested});
        return background;
    }
    const Interaction<N> at = interact(world_, ray, hit, leaving, budget.medium, work_);
    if constexpr (all_effects) {
        if (adds_) { // one test for all that is added, where nothing is
            if (budget.depth == 0) seen_ = {Id(at.hit.object), as<double>(at.facing), false};
            if (world_.effects == EffectMask::all || keeps_brought_)
                return shade_hit_with_effects(ray, at, budget, tested);
        }
    }
    if constexpr (Recorder::enabled) record_boundary(ray, at);
    const Colour local = local_light<false>(at, budget);
    Colour colour = local;
    add_boundary_light(colour, at, budget);
    if constexpr (Recorder::enabled) recorder_.record(RayFinished{local, colour, tested});
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::record_boundary(const Ray<T>& ray, const Interaction<N>& at) {
    recorder_.record(boundary_chosen(at));
    if (const auto triangle = triangle_hit(world_, ray, at.hit)) recorder_.record(*triangle);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
auto Tracer<N, Stage, Recorder, Order, mask>::bent_at(const Interaction<N>& at, T speed_from,
                                                      T speed_to) const -> Refraction<T> {
    const auto bent = refract<N>(at.incoming, at.facing, speed_from, speed_to);
    // An interpolated normal may bend the ray back out of the face that it is to go through.
    if (at.smooth && !bent.total() && !(dot(bent.direction, at.flat) < T(0)))
        return refract<N>(at.incoming, at.flat, speed_from, speed_to);
    return bent;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::add_boundary_light(Colour& colour, const Interaction<N>& at,
                                                                 const Budget& budget) {
    const Material& material = *at.material;
    if (!material.transmits()) {
        colour += mirrored_light(at, material.reflection, budget);
        refuse(RayKind::refracted, Reason::coefficient_zero, material.transmission, budget);
        return;
    }
    const Bend bend{bent_at(at, at.speed_from, at.speed_to), at.speed_from, at.speed_to};
    add_shared_light(colour, at, bend, {material.reflection, material.transmission}, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::add_shared_light(Colour& colour, const Interaction<N>& at,
                                                               const Bend& bend, const Shares& shares,
                                                               const Budget& budget) {
    Colour mirrored = shares.mirrored;
    const bool total = bend.bent.total();
    if (total) {
        // What can't get through is mirrored as well: one ray carries both shares.
        mirrored = at.material->reflection + at.material->transmission;
        note_total_reflection(bend, mirrored);
    }
    colour += mirrored_light(at, mirrored, budget);
    if (total)
        refuse(RayKind::refracted, Reason::total_internal_reflection, at.material->transmission, budget);
    else
        colour += transmitted_light(at, bend, shares.through, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::mirrored_light(const Interaction<N>& at,
                                                               const Colour& coefficient,
                                                               const Budget& budget) {
    if (const auto reason = limits_.refusal(budget, coefficient, rays_left_)) {
        refuse(RayKind::reflected, *reason, coefficient, budget);
        return Colour{0};
    }
    const Vec3<T> direction = mirrored<N>(at.incoming, at.facing);
    if constexpr (Recorder::enabled)
        recorder_.record(
            Reflected{coefficient, angle_of_incidence(at.incoming, at.facing), as<double>(direction)});
    return follow({RayKind::reflected, coefficient, direction, at.back, at.media.from}, at, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::transmitted_light(const Interaction<N>& at, const Bend& bend,
                                                                  const Colour& coefficient,
                                                                  const Budget& budget) {
    if (const auto reason = limits_.refusal(budget, coefficient, rays_left_)) {
        refuse(RayKind::refracted, *reason, coefficient, budget);
        return Colour{0};
    }
    if constexpr (Recorder::enabled)
        recorder_.record(Refracted{coefficient, bend.bent.theta_from(), bend.bent.theta_to(),
                                   bend.critical_angle(), double(bend.bent.eta),
                                   as<double>(bend.bent.direction), bend.wavelength});
    return follow(
        {RayKind::refracted, coefficient, bend.bent.direction, at.through, at.media.to, bend.wavelength}, at,
        budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::follow(const Continuation& next, const Interaction<N>& at,
                                                       const Budget& budget) {
    const Ray<T> ray{at.point, next.direction};
    Budget after = budget.after(next.coefficient, next.medium);
    if constexpr (all_effects) {
        if (adds_) {
            after.path = mixed(budget.path, std::uint32_t(next.kind));
            if (next.wavelength > 0) after.wavelength = float(next.wavelength);
            kind_ = next.kind;
        }
    }
    if constexpr (Order::waits) {
        order_.push({next.kind, ray, next.leaving, after});
        return Colour{0};
    } else {
        --rays_left_;
        ++work_.counters.rays[std::size_t(next.kind)];
        if constexpr (Recorder::enabled) recorder_.record(spawned(next.kind, ray, next.leaving, after));
        return next.coefficient * shade({next.kind}, ray, next.leaving, after);
    }
}

// A waiting ray's weight is the share of all that it will bring: nothing is weighed on a way up.
template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
Colour Tracer<N, Stage, Recorder, Order, mask>::follow_waiting() {
    Colour colour{0};
    for (; !order_.empty() && rays_left_ > 0; --rays_left_) {
        const WaitingRay<T> next = order_.pop();
        ++work_.counters.rays[std::size_t(next.kind)];
        colour += next.budget.weight * shade({next.kind}, next.ray, next.leaving, next.budget);
    }
    while (!order_.empty()) order_.lose(order_.pop().budget.weight);
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::note_total_reflection(const Bend& bend,
                                                                    const Colour& coefficient) {
    ++work_.counters.total_reflections;
    if constexpr (Recorder::enabled)
        recorder_.record(TotallyReflected{coefficient, bend.bent.theta_from(), bend.critical_angle(),
                                          double(bend.bent.eta), bend.wavelength});
}

template <Numbers N, typename Stage, typename Recorder, typename Order, EffectMask mask>
void Tracer<N, Stage, Recorder, Order, mask>::refuse(RayKind kind, Reason reason, const Colour& coefficient,
                                                     const Budget& budget) {
    if (reason == Reason::depth) ++work_.counters.cut_by_depth;
    if (reason == Reason::weight) ++work_.counters.cut_by_weight;
    if (reason == Reason::ray_limit) ++work_.counters.cut_by_ray_limit;
    if (reason == Reason::depth || reason == Reason::weight || reason == Reason::ray_limit) {
        dropped_ += budget.weight * coefficient;
        if constexpr (Order::waits) order_.lose(budget.weight * coefficient);
    }
    if constexpr (Recorder::enabled)
        recorder_.record(
            NotSpawned{kind, reason, largest_component(coefficient), budget.weight * coefficient});
}

} // namespace rayscope
