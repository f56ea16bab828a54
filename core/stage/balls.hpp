#pragma once
// Spheres that no matrix distorts, stored component by component, so that the compiler tests several at once.

#include "core/world/work.hpp"
#include "core/world/world.hpp"

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

template <Numbers N> class Balls {
public:
    using T = ScalarOf<N>;
    static constexpr std::size_t lanes = 8; ///< the widest vectors' doubles

    /// @param ball a solid with is_ball
    void add(const Solid<N>& ball, std::uint32_t object) {
        x_.push_back(ball.transform.translation().x);
        y_.push_back(ball.transform.translation().y);
        z_.push_back(ball.transform.translation().z);
        radius_.push_back(std::get<Sphere<N>>(ball.shape).radius);
        object_.push_back(object);
    }
    /// Fills up with points that stand for no object, until the number of all is one of whole lanes. Not with NaN, which
    /// would do without a name: x87 takes hundreds of cycles for each operation on it.
    void pad() {
        while (x_.size() % lanes != 0) {
            for (auto* column : {&x_, &y_, &z_, &radius_}) column->push_back(T(0));
            object_.push_back(no_object);
        }
    }
    [[nodiscard]] std::size_t size() const { return x_.size(); }
    void reserve(std::size_t count) {
        for (auto* column : {&x_, &y_, &z_, &radius_}) column->reserve(count);
        object_.reserve(count);
    }
    [[nodiscard]] std::size_t bytes() const {
        return x_.capacity() * 4 * sizeof(T) + object_.capacity() * sizeof(std::uint32_t);
    }

    /// Calls hit(object) for each of the balls first … last − 1 that the ray's line meets, in their order, until it returns
    /// true. The test is the Sphere kernel's own arithmetic: a ball passes exactly if its kernel finds a chord.
    /// Both ends are multiples of `lanes`.
    /// @return the ball after the one that ended it, or `last`
    template <typename OnHit>
    std::size_t each_met(const Ray<T>& ray, std::size_t first, std::size_t last, const OnHit& hit) const {
        const T dd = dot(ray.direction, ray.direction), inverse_dd = T(1) / dd;
        for (; first < last; first += lanes)
            for (unsigned met = met_of(ray, dd, inverse_dd, first); met != 0; met &= met - 1) {
                const auto i = std::size_t(std::countr_zero(met));
                if (object_[first + i] != no_object && hit(object_[first + i])) return first + i + 1;
            }
        return last;
    }

private:
    static constexpr std::uint32_t no_object = ~std::uint32_t(0);

    // Bit i: the ray's line meets ball first + i. A function of its own, small enough for the compiler to make vector
    // instructions of it.
    [[gnu::noinline]] unsigned met_of(const Ray<T>& ray, T dd, T inverse_dd, std::size_t first) const {
        const Vec3<T>&o = ray.origin, &d = ray.direction;
        const T *cx = &x_[first], *cy = &y_[first], *cz = &z_[first], *radius = &radius_[first];
        std::array<T, lanes> squared;
        for (std::size_t i = 0; i < lanes; ++i)
            squared[i] = Sphere<N>::Chord::of(o.x - cx[i], o.y - cy[i], o.z - cz[i], d.x, d.y, d.z, dd,
                                              inverse_dd, radius[i])
                             .squared;
        unsigned met = 0;
        for (std::size_t i = 0; i < lanes; ++i) met |= unsigned(squared[i] > T(0)) << i;
        return met;
    }

    std::vector<T> x_, y_, z_, radius_;
    std::vector<std::uint32_t> object_;
};

} // namespace rayscope
