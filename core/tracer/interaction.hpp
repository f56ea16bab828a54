#pragma once
// What the shading needs to know of a hit.

#include "core/tracer/media_at.hpp"

namespace rayscope {

template <Scalar T> struct Interaction {
    Hit<T> hit;
    Vec3<T> point;
    Vec3<T> incoming; ///< the ray's direction, unit
    Vec3<T> normal;   ///< unit, outward from the object
    Vec3<T> facing;   ///< turned against the ray
    T error_bound;    ///< of t
    MediaPair media;
    T speed_from = T(1), speed_to = T(1);
    Leaving<T> back;          ///< what a ray that stays on this side leaves
    Leaving<T> through;       ///< what a ray that goes on leaves
    const Material* material; ///< reflection, transmission, speed: the object's
    const Material* wall;     ///< ambient, diffuse, specular: the operand's own, where it has one

    /// The ray leaves, through its own boundary, a solid that transmits light: its inner wall is not lit.
    bool leaves_transmitting_solid = false;
};

/// Unit normal for shading: a smooth polygon's interpolated one, else the surface's.
template <Scalar T>
[[nodiscard]] Vec3<T> shading_normal(const World<T>& world, const Ray<T>& ray, const Hit<T>& hit) {
    const Solid<T>& solid = world.solids[hit.surface.solid];
    Vec3<T> n = solid.normal(ray, hit.t, hit.surface.face);
    if (const auto* polygon = std::get_if<Polygon<T>>(&solid.shape);
        polygon != nullptr && polygon->smooth()) {
        const Vec3<T> smooth = solid.transform.normal_to_world(
            polygon->shading_normal(solid.transform.to_object(ray).at(hit.t)));
        // Where the smooth normal would turn away from the ray it can't be used: the eye sees the front.
        if (dot(smooth, ray.direction) * dot(n, ray.direction) > T(0)) n = smooth;
    }
    return hit.surface.flipped ? -n : n;
}

template <Scalar T>
[[nodiscard]] Interaction<T> interact(const World<T>& world, const Ray<T>& ray, const Hit<T>& hit,
                                      const Leaving<T>& leaving, std::int64_t medium, Work<T>& work) {
    Interaction<T> at{};
    at.media = {medium, medium};
    const Object& object = world.objects[hit.object];
    at.hit = hit;
    at.hit.surface = owner(world, ray, hit, leaving.of(hit.object), work);
    const Solid<T>& solid = world.solids[at.hit.surface.solid];
    at.point = ray.at(hit.t);
    at.incoming = normalized(ray.direction);
    at.normal = shading_normal(world, ray, at.hit);
    at.error_bound = solid.error_bound(ray, hit.t, at.hit.surface.face);
    at.material = &world.material_of(object);
    at.wall = &world.materials[solid.material];
    const T along = dot(at.normal, at.incoming);
    const bool against = object.has_volume ? hit.entering : along < T(0);
    at.facing = against ? at.normal : -at.normal;

    // The distance along the normal stays small where a graze makes the bound of t large.
    at.back.bound = at.through.bound = at.error_bound * magnitude(dot(at.normal, ray.direction));
    at.back.add({hit.object, at.hit.surface, !hit.entering});
    at.through.add({hit.object, at.hit.surface, hit.entering});
    at.leaves_transmitting_solid = object.has_volume && !hit.entering && at.material->transmits();
    if (at.material->transmits()) {
        at.media = media_at(world, ray, at.hit, leaving, at.through, work);
        at.speed_from = speed_in(world, at.media.from);
        at.speed_to = speed_in(world, at.media.to);
        for (int i = 1; i < at.through.count; ++i) {
            LeavingSurface other = at.through.items[std::size_t(i)];
            other.starts_inside = !other.starts_inside;
            at.back.add(other);
        }
    }
    return at;
}

} // namespace rayscope
