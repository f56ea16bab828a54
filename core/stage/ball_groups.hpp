#pragma once
// Balls in groups: their centres and radii.

#include "core/stage/balls.hpp"

#include <experimental/simd>

namespace rayscope {

/// All x, all y, all z, all radii.
template <Numbers N> class BallGroups : public Groups<ScalarOf<N>, 4> {
public:
    using T = ScalarOf<N>;

    void add(const Solid<N>& ball, std::uint32_t object) {
        const Vec3<T>& centre = ball.transform.translation();
        Groups<T, 4>::add({centre.x, centre.y, centre.z, std::get<Sphere<N>>(ball.shape).radius}, object);
    }

    /// Calls hit(object) for each of the balls first … last − 1, which are whole groups, that may have a crossing with
    /// 0 ≤ t ≤ reach, until it returns true.
    /// @return the ball after the one that ended it, or `last`
    template <typename OnHit>
    std::size_t each_near(const GroupRay<T>& ray, T reach, std::size_t first, std::size_t last,
                          const OnHit& hit) const {
        const auto near = [&](const T* numbers, std::size_t count) {
            return near_of(ray, reach, numbers, count);
        };
        return this->each(first, last, near, hit);
    }

private:
    // Bit i: the Sphere kernel finds a chord of ball i, and it may lie in the range. Both of its ends are within a radius
    // of its middle; the slack is far above what a kernel's mended root, or a compound's merged crossings, may lie
    // beside them.
    [[gnu::noinline]] static unsigned near_of(const GroupRay<T>& ray, T reach, const T* numbers,
                                              std::size_t count) {
        const T *cx = numbers, *cy = cx + count, *cz = cy + count, *radius = cz + count;
        constexpr T slack = limits::power_of_half<T>(limits::digits<T> / 2 - 6);
        const T widened = ray.inverse_length * (T(1) + slack);
        alignas(64) std::array<T, group_lanes> least;
        for (std::size_t i = 0; i < group_lanes; ++i) {
            const auto chord = Sphere<N>::Chord::of(ray.x - cx[i], ray.y - cy[i], ray.z - cz[i], ray.dx,
                                                    ray.dy, ray.dz, ray.dd, ray.inverse_dd, radius[i]);
            const T half = fma(radius[i], widened, slack * magnitude(chord.middle));
            least[i] = minimum(chord.squared, minimum(half + chord.middle, half + (reach - chord.middle)));
        }
        using Lanes = std::experimental::native_simd<T>;
        unsigned near = 0;
        for (std::size_t part = 0; part < group_lanes; part += Lanes::size()) {
            const auto positive = Lanes(&least[part], std::experimental::vector_aligned) > T(0);
            for (std::size_t i = 0; i < Lanes::size(); ++i) near |= unsigned(positive[i]) << (part + i);
        }
        return near;
    }
};

} // namespace rayscope
