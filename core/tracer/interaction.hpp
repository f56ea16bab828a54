#pragma once
// What the shading needs to know of a hit.

#include "core/reflection/mirror.hpp"
#include "core/tracer/media_at.hpp"

namespace rayscope {

template <Numbers N> struct Interaction {
    using T = ScalarOf<N>;

    Hit<T> hit;
    Vec3<T> point;
    Vec3<T> incoming; ///< the ray's direction, unit
    Vec3<T> normal;   ///< unit, outward from the object
    Vec3<T> facing;   ///< turned against the ray
    Vec3<T> flat;     ///< the face's own, turned so: `facing`, unless the surface is smooth
    bool smooth = false;
    T error_bound; ///< of t
    MediaPair media;
    T speed_from = T(1), speed_to = T(1);
    Leaving<T> back;          ///< what a ray that stays on this side leaves
    Leaving<T> through;       ///< what a ray that goes on leaves
    const Material* material; ///< reflection, transmission, speed: the object's
    const Material* wall;     ///< ambient, diffuse, specular: the operand's own, where it has one

    /// The ray leaves, through its own boundary, a solid that transmits light: its inner wall is not lit.
    bool leaves_transmitting_solid = false;
};

template <Numbers N> [[nodiscard]] bool is_smooth(const Solid<N>& solid) {
    if (const auto* polygon = std::get_if<Polygon<N>>(&solid.shape)) return polygon->smooth();
    const auto* mesh = std::get_if<Mesh<N>>(&solid.shape);
    return mesh != nullptr && mesh->smooth();
}

/// Unit normal of a smooth polygon or mesh where it was hit, turned against the ray like its face's own, `flat`; nothing
/// where it can't be used.
/// Interpolated it belongs to a curved surface that is not there, so the face's own normal guards it: it does not turn
/// away from the ray, since the eye sees the front, nor so far aside that the mirrored ray would lead through the face. Such a
/// ray is turned up over the face by as much as it would dip below.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard, gnu::noinline]] std::optional<Vec3<T>> smooth_normal(const Solid<N>& solid, const Ray<T>& ray,
                                                                  const Hit<T>& hit, const Vec3<T>& incoming,
                                                                  const Vec3<T>& flat) {
    const auto* polygon = std::get_if<Polygon<N>>(&solid.shape);
    const auto* mesh = std::get_if<Mesh<N>>(&solid.shape);
    const Vec3<T> p = solid.transform.to_object(ray).at(hit.t);
    Vec3<T> n = solid.transform.normal_to_world(
        polygon != nullptr ? polygon->shading_normal(p) : mesh->shading_normal(p, int(hit.surface.face)));
    if (dot(n, flat) < T(0)) n = -n; // whichever side its file means
    if (!(dot(n, incoming) < T(0))) return std::nullopt;
    const Vec3<T> direction = mirrored<N>(incoming, n);
    const T height = dot(direction, flat);
    if (height >= T(0)) return n;
    n = normalized(direction - T(2) * height * flat - incoming);
    if (!(dot(n, incoming) < T(0))) return std::nullopt;
    return n;
}

/// The hits that coincide with the nearest one: those within the sum of their error bounds, itself included. A place
/// where several objects meet belongs to the one that is first in the file, which is returned; who of them rounding
/// put first is not asked. The schoolbook takes the nearest.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Hit<T> first_in_file(const World<N>& world, const Ray<T>& ray, const Nearest<T>& nearest,
                                   std::vector<Hit<T>>& coincident) {
    const auto crossing = [](const Hit<T>& hit) { return Crossing<T>{hit.t, hit.surface, hit.entering}; };
    coincident.clear();
    Hit<T> first = *nearest;
    if (is_textbook<N> || nearest.all().size() == 1) return first;
    for (const Hit<T>& hit : nearest.all()) {
        if (!coincide(world, ray, crossing(*nearest), crossing(hit))) continue;
        coincident.push_back(hit);
        if (hit.object < first.object) first = hit;
    }
    // In which order a stage came upon them is no concern of what follows.
    std::sort(coincident.begin(), coincident.end(),
              [](const Hit<T>& a, const Hit<T>& b) { return a.object < b.object; });
    return first;
}

/// Which surfaces the rays that go on from a hit start on. (The schoolbook's start on none, but at secondary_start.)
/// @param bound, beside see LeavingSurface
template <Numbers N, Scalar T = ScalarOf<N>>
void leave_from(Interaction<N>& at, const World<N>& world, const Leaving<T>& before,
                const std::vector<Hit<T>>& coincident, T bound, T beside) {
    const auto side = [&](const auto& hit, bool inside, bool crosses) {
        return LeavingSurface<T>{hit.object, hit.surface, inside, crosses, bound, beside};
    };
    at.back.add(side(at.hit, !at.hit.entering, false));
    at.through.add(side(at.hit, at.hit.entering, false));
    for (const Hit<T>& other : coincident) {
        if (other.object == at.hit.object) continue;
        at.back.add(side(other, !other.entering, false));
        // Light goes through coincident boundaries of media at once; what is opaque it meets there.
        const bool opaque = !world.material_of(other.object).transmits();
        at.through.add(side(other, opaque != other.entering, opaque));
    }
    // A hit at the very start, in the gap without width between two objects: the way back leads through the first one.
    if (at.hit.t > T(0)) return;
    for (const LeavingSurface<T>& surface : before)
        if (!surface.crosses) at.back.add(side(surface, surface.starts_inside, true));
}

/// Where a formula of somebody else's may decide what happens at the wall of what transmits (core/substitute); ours has
/// decided already.
template <Numbers N> void reconsider_wall(const World<N>& /*world*/, Interaction<N>& /*at*/) {}

template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Interaction<N> interact(const World<N>& world, const Ray<T>& ray, const Nearest<T>& nearest,
                                      const Leaving<T>& leaving, Id medium, Work<T>& work) {
    Interaction<N> at; // its lists are long, and hold nothing yet: not worth clearing
    at.hit = first_in_file(world, ray, nearest, work.coincident);
    if (at.hit.crowded) at.hit.surface = owner(world, ray, at.hit, leaving.of(at.hit.object), work);
    at.point = ray.at(at.hit.t);
    at.incoming = normalized(ray.direction);

    const Object& object = world.objects[at.hit.object];
    const Solid<N>& solid = world.solids[at.hit.surface.solid];
    at.material = &world.material_of(object);
    at.wall = &world.materials[solid.material];
    const auto place = solid.place(ray, at.hit.t, at.hit.surface.face);
    at.error_bound = place.error_bound;
    at.normal = place.normal;
    if (at.hit.surface.flipped) at.normal = -at.normal;
    const bool against = object.has_volume ? at.hit.entering : dot(at.normal, at.incoming) < T(0);
    at.facing = at.flat = against ? at.normal : -at.normal;
    if (is_smooth(solid)) {
        if (const auto smooth = smooth_normal(solid, ray, at.hit, at.incoming, at.flat)) {
            at.smooth = true;
            at.facing = *smooth;
            at.normal = against ? at.facing : -at.facing;
        }
    }
    at.leaves_transmitting_solid = object.has_volume && !at.hit.entering && at.material->transmits();

    if constexpr (!is_textbook<N>) {
        // Along the normal the bound stays small where a graze makes that of t large; the point itself is rounded, too.
        const T rounding = epsilon<T> * dot(absolute(at.flat), absolute(at.point));
        const T bound = fma(at.error_bound, magnitude(dot(at.flat, ray.direction)), rounding);
        // In any direction; what coincides may add as much.
        const T beside = T(4) * fma(at.error_bound, largest_component(absolute(ray.direction)),
                                    epsilon<T> * largest_component(absolute(at.point)));
        leave_from(at, world, leaving, work.coincident, bound, beside);
    }
    at.media = {medium, medium};
    if (at.material->transmits()) {
        at.media = media_at(world, ray, at.hit, leaving, work);
        at.speed_from = speed_in(world, at.media.from);
        at.speed_to = speed_in(world, at.media.to);
        reconsider_wall(world, at);
    }
    return at;
}

} // namespace rayscope
