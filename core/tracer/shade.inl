#pragma once
// The tracer's steps, in the order in which light is gathered: what is hit, what lights it, what it mirrors, what it
// lets through.

#include "core/tracer/tracer.hpp"

namespace rayscope {

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::trace(const Ray<T>& ray, int x, int y) {
    eye_ = {RayKind::eye, x, y, none};
    rays_left_ = world_.max_rays;
    deepest_ = 0;
    const Leaving<T> nothing;
    Budget budget;
    ++work_.counters.rays[std::size_t(RayKind::eye)];
    if constexpr (Recorder::enabled) {
        budget.medium = medium_at_start(world_, ray, work_);
        recorder_.record(spawned(RayKind::eye, ray, nothing, budget));
    }
    Colour colour = shade(eye_, ray, nothing, budget);
    if constexpr (Order::waits) colour += follow_waiting();
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::shade(const RayUse& use, const Ray<T>& ray,
                                                const Leaving<T>& leaving, const Budget& budget) {
    deepest_ = std::max(deepest_, budget.depth);
    const std::uint64_t before = work_.counters.objects;
    const Range<T> range{budget.depth == 0 ? T(0) : secondary_start<N>};
    const auto hit = stage_.closest(use, ray, range, leaving, work_, recorder_);
    const int tested = int(work_.counters.objects - before);
    if (!hit) {
        if constexpr (Recorder::enabled) {
            recorder_.record(Missed{world_.background});
            recorder_.record(RayFinished{world_.background, world_.background, tested});
        }
        return world_.background;
    }
    const Interaction<N> at = interact(world_, ray, hit, leaving, budget.medium, work_);
    if constexpr (Recorder::enabled) {
        recorder_.record(boundary_chosen(at));
        if (const auto triangle = triangle_hit(world_, ray, at.hit)) recorder_.record(*triangle);
    }

    const Colour local = local_light(at, budget);
    std::optional<Refraction<T>> bent;
    if (at.material->transmits()) {
        bent = refract<N>(at.incoming, at.facing, at.speed_from, at.speed_to);
        // An interpolated normal may bend the ray back out of the face that it is to go through.
        if (at.smooth && !bent->total() && !(dot(bent->direction, at.flat) < T(0)))
            bent = refract<N>(at.incoming, at.flat, at.speed_from, at.speed_to);
    }
    const bool total = bent && bent->total();
    // What can't get through is mirrored as well: one ray carries both shares.
    const Colour mirrored_share =
        total ? at.material->reflection + at.material->transmission : at.material->reflection;
    if (total) note_total_reflection(*bent, mirrored_share, at);

    Colour colour = local;
    colour += mirrored_light(at, mirrored_share, budget);
    if (bent && !total)
        colour += transmitted_light(at, *bent, budget);
    else
        refuse(RayKind::refracted, total ? Reason::total_internal_reflection : Reason::coefficient_zero,
               at.material->transmission, budget);
    if constexpr (Recorder::enabled) recorder_.record(RayFinished{local, colour, tested});
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::local_light(const Interaction<N>& at, const Budget& budget) {
    if (at.leaves_transmitting_solid) {
        if constexpr (Recorder::enabled) recorder_.record(LocalLightSkipped{});
        return Colour{0};
    }
    if constexpr (Recorder::enabled) recorder_.record(AmbientLit{world_.ambient, at.wall->ambient});
    Colour colour = world_.ambient * at.wall->ambient;
    for (Id light = 0; light < Id(world_.lights.size()); ++light) colour += light_from(light, at, budget);
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::light_from(Id id, const Interaction<N>& at, const Budget& budget) {
    const Light& light = world_.lights[std::size_t(id)];
    const Vec3<T> position = as<T>(light.position);
    const Vec3<T> offset = light.directional ? position : position - at.point;
    const Vec3<T> to_light = normalized(offset);
    double cosine = double(dot(at.facing, to_light));
    // Light from behind the face itself does not come through, whatever an interpolated normal says.
    if (const double flat = double(dot(at.flat, to_light)); at.smooth && flat < 0)
        cosine = minimum(cosine, flat);
    const double mirror = double(mirror_cosine(to_light, at.facing, at.incoming));
    const Colour diffuse = at.wall->diffuse * diffuse_share(cosine);
    const Colour specular = at.wall->specular * specular_share(cosine, mirror, at.wall->shininess);
    // A light behind the surface, or one that the material ignores, needs no shadow ray.
    Colour seen{1};
    if (light.shadows && largest_component(diffuse + specular) > 0)
        seen = visibility(id, to_light, light.directional ? infinity<T> : length(offset), at, budget);
    const Colour arriving = light.colour * seen;
    if constexpr (Recorder::enabled)
        recorder_.record(LightLit{id, as<double>(to_light), cosine, mirror, at.wall->shininess, light.colour,
                                  seen, at.wall->diffuse, at.wall->specular, diffuse * arriving,
                                  specular * arriving});
    return diffuse * arriving + specular * arriving;
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::visibility(Id light, const Vec3<T>& to_light, T distance,
                                                     const Interaction<N>& at, const Budget& budget) {
    const Ray<T> ray{at.point, to_light};
    ++work_.counters.rays[std::size_t(RayKind::shadow)];
    if constexpr (Recorder::enabled)
        recorder_.record(spawned(RayKind::shadow, ray, at.back, budget, distance, light));
    const std::uint64_t before = work_.counters.objects;
    const RayUse use{RayKind::shadow, none, none, light};
    const bool dark =
        stage_.blocked(use, ray, Range<T>{secondary_start<N>, distance}, at.back, work_, recorder_);
    Colour seen{dark ? 0.0 : 1.0};
    if (!dark) {
        for (const Blocker<T>& blocker : work_.blockers) {
            const Colour& transmission = world_.material_of(blocker.object).transmission;
            if constexpr (Recorder::enabled)
                recorder_.record(BlockerPassed{Id(blocker.object), double(blocker.t), transmission});
            seen *= transmission;
        }
    }
    if constexpr (Recorder::enabled)
        recorder_.record(RayFinished{seen, seen, int(work_.counters.objects - before)});
    return seen;
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::mirrored_light(const Interaction<N>& at, const Colour& coefficient,
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

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::transmitted_light(const Interaction<N>& at,
                                                            const Refraction<T>& bent, const Budget& budget) {
    const Colour& transmission = at.material->transmission;
    if (const auto reason = limits_.refusal(budget, transmission, rays_left_)) {
        refuse(RayKind::refracted, *reason, transmission, budget);
        return Colour{0};
    }
    if constexpr (Recorder::enabled)
        recorder_.record(
            Refracted{transmission, bent.theta_from(), bent.theta_to(),
                      critical_angle(double(at.speed_from), double(at.speed_to)).value_or(not_a_number),
                      double(bent.eta), as<double>(bent.direction)});
    return follow({RayKind::refracted, transmission, bent.direction, at.through, at.media.to}, at, budget);
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::follow(const Continuation& next, const Interaction<N>& at,
                                                 const Budget& budget) {
    const Ray<T> ray{at.point, next.direction};
    const Budget after = budget.after(next.coefficient, next.medium);
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
template <Numbers N, typename Stage, typename Recorder, typename Order>
Colour Tracer<N, Stage, Recorder, Order>::follow_waiting() {
    Colour colour{0};
    for (; !order_.empty() && rays_left_ > 0; --rays_left_) {
        const WaitingRay<T> next = order_.pop();
        ++work_.counters.rays[std::size_t(next.kind)];
        colour += next.budget.weight * shade({next.kind}, next.ray, next.leaving, next.budget);
    }
    while (!order_.empty()) order_.lose(order_.pop().budget.weight);
    return colour;
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
void Tracer<N, Stage, Recorder, Order>::note_total_reflection(const Refraction<T>& bent,
                                                              const Colour& coefficient,
                                                              const Interaction<N>& at) {
    ++work_.counters.total_reflections;
    if constexpr (Recorder::enabled)
        recorder_.record(TotallyReflected{
            coefficient, bent.theta_from(),
            critical_angle(double(at.speed_from), double(at.speed_to)).value_or(not_a_number),
            double(bent.eta)});
}

template <Numbers N, typename Stage, typename Recorder, typename Order>
void Tracer<N, Stage, Recorder, Order>::refuse(RayKind kind, Reason reason, const Colour& coefficient,
                                               const Budget& budget) {
    if (reason == Reason::depth) ++work_.counters.cut_by_depth;
    if (reason == Reason::weight) ++work_.counters.cut_by_weight;
    if (reason == Reason::ray_limit) ++work_.counters.cut_by_ray_limit;
    if constexpr (Order::waits)
        if (reason == Reason::depth || reason == Reason::weight || reason == Reason::ray_limit)
            order_.lose(budget.weight * coefficient);
    if constexpr (Recorder::enabled)
        recorder_.record(NotSpawned{kind, reason, largest_component(coefficient),
                                    largest_component(budget.weight * coefficient)});
}

} // namespace rayscope
