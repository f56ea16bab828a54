#pragma once
// Objects that a stage has no place for.

#include "core/stage/apart.hpp"

#include <vector>

namespace rayscope {

/// Every ray is tested against them, but for planes and polygons of which it surely stays on one side: a shadow ray from
/// above a floor to a light above it never gets there.
template <Numbers N> class Unboxed {
public:
    using T = ScalarOf<N>;

    Unboxed() = default;
    Unboxed(const World<N>& world, const std::vector<std::uint32_t>& objects) {
        for (const std::uint32_t object : objects) entries_.push_back(entry(world, object));
    }

    /// Calls search.test(object) for each that the search's ray may meet, until it returns true; so does this then.
    template <typename Search> bool test(Search& search) const {
        for (const Entry& entry : entries_)
            if (may_meet(entry, search.ray(), search.reach()) && search.test(entry.object)) return true;
        return false;
    }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }

private:
    struct Entry {
        std::uint32_t object;
        bool flat = false;
        Vec3<T> normal{T(0)}; ///< unit; of the plane that it lies in
        T offset = T(0);      ///< normal · p of its points
        T size = T(0);        ///< its largest coordinate; of a plane that of the point that its matrix moves
        T rounding = T(0);    ///< relative to coordinates, as SlabRay has it
    };

    [[nodiscard]] static Entry entry(const World<N>& world, std::uint32_t id) {
        const Object& object = world.objects[id];
        if (object.is_compound) return {id};
        const Solid<N>& solid = world.solids[object.index];
        Vec3<T> point{T(0)}, normal{T(0), T(0), T(1)};
        T size = T(0); // of a polygon
        if (const auto* polygon = std::get_if<Polygon<N>>(&solid.shape)) {
            point = polygon->vertices().front();
            normal = polygon->normal(point, 0);
            size = largest_coordinate(as<T>(object.bounds));
        } else if (!std::holds_alternative<Plane<N>>(solid.shape)) {
            return {id};
        }
        const Vec3<T> moved = Vec3<T>(solid.transform.matrix() * glm::tvec4<T>(point, T(1)));
        normal = solid.transform.normal_to_world(normal);
        return {id,
                true,
                normal,
                dot(normal, moved),
                maximum(size, largest_component(absolute(moved))),
                T(64) * epsilon<T> * solid.transform.distortion()};
    }

    /// False: for 0 ≤ t ≤ reach the ray stays farther from the plane than rounding can carry a crossing.
    [[nodiscard]] static bool may_meet(const Entry& entry, const Ray<T>& ray, T reach) {
        if (!entry.flat) return true;
        const T height = dot(entry.normal, ray.origin) - entry.offset;
        const T rises = dot(entry.normal, ray.direction);
        const T away = height > T(0) ? rises : -rises, step = largest_component(absolute(ray.direction));
        const T far = largest_component(absolute(ray.origin)) + entry.size;
        if (!(magnitude(height) > entry.rounding * far)) return true;
        if (away > entry.rounding * step) return false;
        return !(magnitude(height) + reach * away > entry.rounding * (far + reach * step));
    }

    std::vector<Entry> entries_;
};

} // namespace rayscope
