#pragma once
// Spheres that no matrix distorts, stored component by component, so that the compiler tests several at once.

#include "core/world/world.hpp"

#include <algorithm>
#include <optional>

namespace rayscope {

/// The solid of an object that is a sphere in world space and without which the object has no crossing: a plain ball
/// itself; of a compound, the operand from which all the rest is taken, as the outer sphere of a bowl.
template <Numbers N>
[[nodiscard]] std::optional<std::uint32_t> deciding_ball(const World<N>& world, const Object& object) {
    if (world.is_ball(object)) return object.index;
    if (!object.is_compound) return std::nullopt;
    const Program& program = world.compounds[object.index].program;
    const bool rest_is_guarded = program.size() > 1 && program[0].kind == Instruction::Kind::leaf &&
                                 program[1].kind == Instruction::Kind::guard &&
                                 program[1].operand == program.size();
    if (!rest_is_guarded || !world.solids[program[0].operand].is_ball) return std::nullopt;
    return program[0].operand;
}

template <Numbers N> class BallBlocks {
public:
    using T = ScalarOf<N>;

    /// Takes up the objects that deciding_ball names a ball for.
    explicit BallBlocks(const World<N>& world);

    /// Calls hit(object) for each object whose ball the ray's line meets, in the order of the file, until it returns true.
    /// The test is the Sphere kernel's own arithmetic, so a ball passes here exactly if its kernel finds a chord.
    /// @return how many balls were tested
    template <typename OnHit> std::size_t each_met(const Ray<T>& ray, const OnHit& hit) const;

private:
    static constexpr std::size_t block = 64, lanes = 8; // tested in one go; and by the widest vectors at once

    std::vector<T> x_, y_, z_, radius_; // padded to whole lanes with NaN, which no ray meets
    std::vector<std::uint32_t> object_;
};

template <Numbers N> BallBlocks<N>::BallBlocks(const World<N>& world) {
    for (std::uint32_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        const auto ball = deciding_ball(world, object);
        if (!ball) continue;
        const Solid<N>& solid = world.solids[*ball];
        x_.push_back(solid.transform.translation().x);
        y_.push_back(solid.transform.translation().y);
        z_.push_back(solid.transform.translation().z);
        radius_.push_back(std::get<Sphere<N>>(solid.shape).radius);
        object_.push_back(id);
    }
    while (x_.size() % lanes != 0)
        for (auto* column : {&x_, &y_, &z_, &radius_})
            column->push_back(T(std::numeric_limits<double>::quiet_NaN()));
}

template <Numbers N>
template <typename OnHit>
std::size_t BallBlocks<N>::each_met(const Ray<T>& ray, const OnHit& hit) const {
    const T dx = ray.direction.x, dy = ray.direction.y, dz = ray.direction.z;
    const T x = ray.origin.x, y = ray.origin.y, z = ray.origin.z;
    const T dd = dot(ray.direction, ray.direction);
    const T inverse_dd = T(1) / dd;
    std::array<T, block> squared;
    for (std::size_t first = 0; first < x_.size(); first += block) {
        const std::size_t count = std::min(block, x_.size() - first);
        const T *cx = &x_[first], *cy = &y_[first], *cz = &z_[first], *radius = &radius_[first];
        for (std::size_t i = 0; i < count; ++i)
            squared[i] =
                Sphere<N>::Chord::of(x - cx[i], y - cy[i], z - cz[i], dx, dy, dz, dd, inverse_dd, radius[i])
                    .squared;
        for (std::size_t i = 0; i < count; ++i)
            if (squared[i] > T(0)) [[unlikely]]
                if (hit(object_[first + i])) return first + i + 1;
    }
    return object_.size();
}

} // namespace rayscope
