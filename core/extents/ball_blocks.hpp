#pragma once
// Spheres that no matrix distorts, stored component by component, so that the compiler tests several at once.

#include "core/world/world.hpp"

namespace rayscope {

template <Scalar T> class BallBlocks {
public:
    /// Takes up the plain solids that are world-space spheres.
    explicit BallBlocks(const World<T>& world);

    /// Calls hit(object) for each ball that the ray's line meets, in the order of the file, until it returns true.
    /// The test is the Sphere kernel's own arithmetic, so a ball passes here exactly if its kernel finds a chord.
    /// @return how many balls were tested
    template <typename OnHit> std::size_t each_met(const Ray<T>& ray, const OnHit& hit) const;

private:
    static constexpr std::size_t block = 64;

    std::vector<T> x_, y_, z_, radius_; // padded to whole blocks with NaN, which no ray meets
    std::vector<std::uint32_t> object_;
};

template <Scalar T> BallBlocks<T>::BallBlocks(const World<T>& world) {
    for (std::uint32_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        if (!world.is_ball(object)) continue;
        const Solid<T>& solid = world.solids[object.index];
        x_.push_back(solid.transform.translation().x);
        y_.push_back(solid.transform.translation().y);
        z_.push_back(solid.transform.translation().z);
        radius_.push_back(std::get<Sphere<T>>(solid.shape).radius);
        object_.push_back(id);
    }
    while (x_.size() % block != 0)
        for (auto* column : {&x_, &y_, &z_, &radius_}) column->push_back(std::numeric_limits<T>::quiet_NaN());
}

template <Scalar T>
template <typename OnHit>
std::size_t BallBlocks<T>::each_met(const Ray<T>& ray, const OnHit& hit) const {
    const T dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
    const T x = ray.origin.x, y = ray.origin.y, z = ray.origin.z;
    const T dd = dot(ray.direction, ray.direction);
    const T inverse_dd = T(1) / dd;
    std::array<T, block> squared;
    for (std::size_t first = 0; first < x_.size(); first += block) {
        const T *cx = &x_[first], *cy = &y_[first], *cz = &z_[first], *radius = &radius_[first];
        for (std::size_t i = 0; i < block; ++i)
            squared[i] =
                Sphere<T>::Chord::of(x - cx[i], y - cy[i], z - cz[i], dx, dy, dz, dd, inverse_dd, radius[i])
                    .squared;
        for (std::size_t i = 0; i < block; ++i)
            if (squared[i] > T(0)) [[unlikely]]
                if (hit(object_[first + i])) return first + i + 1;
    }
    return object_.size();
}

} // namespace rayscope
