#pragma once
// Which objects of a list a ray surely misses, from one line of the cache each.

#include "core/stage/balls.hpp"

#include <vector>

namespace rayscope {

/// Knows the spheres of the objects that have a deciding_ball.
template <Numbers N> class BallFilter {
public:
    using T = ScalarOf<N>;

    explicit BallFilter(const World<N>& world) {
        balls_.reserve(world.objects.size());
        for (const Object& object : world.objects) {
            const auto ball = deciding_ball(world, object);
            balls_.push_back(
                ball ? Ball{world.solids[*ball].transform.translation(), squared(world.solids[*ball])}
                     : Ball{});
        }
    }

    /// True if the object has no crossing with t > 0 by a margin far above rounding. It is then counted as tested.
    [[nodiscard]] bool misses(std::uint32_t object, const Ray<T>& ray, Counters& counters) const {
        const Ball& ball = balls_[object];
        const Vec3<T> o = ray.origin - ball.centre;
        const T oo = dot(o, o), od = dot(o, ray.direction), dd = dot(ray.direction, ray.direction);
        // The squared distance of the line from the centre is oo − od² / dd.
        const T squared = fma(slack, oo, ball.squared);
        const bool missed =
            is_safe_square(oo * dd) && (oo * dd - od * od > squared * dd || (od > T(0) && oo > squared));
        if (missed) {
            ++counters.objects;
            ++counters.tests[generic_index<N, Sphere<N>>()];
        }
        return missed;
    }

    [[nodiscard]] std::size_t bytes() const { return balls_.capacity() * sizeof(Ball); }

private:
    static constexpr T slack = T(1024) * epsilon<T>;

    struct Ball {
        Vec3<T> centre{T(0)};
        T squared = infinity<T>; ///< radius²; infinite: the object is no ball
    };
    [[nodiscard]] static T squared(const Solid<N>& ball) {
        const T radius = std::get<Sphere<N>>(ball.shape).radius;
        return radius * radius;
    }

    std::vector<Ball> balls_; // by object
};

} // namespace rayscope
