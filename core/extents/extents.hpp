#pragma once
// The second stage: the generic's box is tested first, in the generic's own space.

#include "core/boxes/slab_ray.hpp"
#include "core/stage/apart.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/search.hpp"

namespace rayscope {

/// A box around each solid in object space: for most generics the notes' cube. A ray that misses it needs no test of what
/// is in it. Whether that pays depends on what is in it: a box costs more than a ball, and less than a torus.
template <Numbers N> class Extents : public StageBase<N, Extents<N>> {
public:
    using T = ScalarOf<N>;

    explicit Extents(const World<N>& world) : StageBase<N, Extents<N>>(world) {
        for (const Object& object : world.objects) {
            apart_.push_back(stands_apart(world, object));
            distortion_.push_back(maximum(T(3), distortion_of(world, object)));
        }
    }

    template <typename Search> [[gnu::noinline]] void look(const RayUse& /*use*/, Search& search) const {
        Counters& counters = search.work().counters;
        for (std::uint32_t id = 0; id < this->world_.objects.size(); ++id) {
            if (!apart_[id]) {
                ++counters.boxes;
                if (!may_hit(id, search.ray(), search.reach())) {
                    ++counters.boxes_missed;
                    continue;
                }
                if constexpr (Search::recording) search.recorder().record(extent_entered(id, search.ray()));
            }
            if (search.test(id)) return;
        }
    }

private:
    [[nodiscard]] PlaceEntered extent_entered(std::uint32_t id, const Ray<T>& ray) const {
        const Box<T> box = as<T>(this->world_.objects[id].bounds);
        const BoxSpan<T> inside = slab_ray(id, box, ray).span(box);
        PlaceEntered entered = place_entered(PlaceKind::extent, Id(id), 0, 1, box, inside.enter, inside.exit);
        entered.object = Id(id);
        return entered;
    }
    /// For the object's box in world space.
    [[nodiscard]] SlabRay<T> slab_ray(std::uint32_t id, const Box<T>& box, const Ray<T>& ray) const {
        return {ray, largest_coordinate(box), distortion_[id]};
    }
    [[nodiscard]] bool may_hit(std::uint32_t id, const Ray<T>& ray, T reach) const {
        const Object& object = this->world_.objects[id];
        if (object.is_compound) { // the box that its parts make together, in world space
            const Box<T> box = as<T>(object.bounds);
            return may_hit(slab_ray(id, box, ray), box, reach);
        }
        const Solid<N>& solid = this->world_.solids[object.index];
        const Box<T> box = std::visit([](const auto& s) { return s.bounds(); }, solid.shape);
        // Here the point_error of Transform is what rounding can do, up to where the ray has passed the box.
        const Ray<T> moved = solid.transform.to_object(ray);
        const T passed = (largest_coordinate(Box<T>{moved.origin, moved.origin}) + largest_coordinate(box)) /
                         largest_component(absolute(moved.direction));
        const T size = largest_component(solid.transform.point_error(ray, passed)) + largest_coordinate(box);
        return may_hit(SlabRay<T>(moved, size, T(1)), box, reach);
    }
    [[nodiscard]] static bool may_hit(const SlabRay<T>& ray, const Box<T>& box, T reach) {
        return !ray.reliable() || ray.may_hit(box, reach);
    }

    // By object.
    std::vector<bool> apart_;
    std::vector<T> distortion_;
};

} // namespace rayscope
