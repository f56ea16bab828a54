#pragma once
// Balls in groups, each group's numbers side by side in memory: what a tree tests in a leaf.

#include "core/stage/balls.hpp"

#include <experimental/simd>

namespace rayscope {

/// Up to eight balls: all x, all y, all z, all radii. A group that is not full takes no more room than its balls.
template <Numbers N> class BallGroups {
public:
    using T = ScalarOf<N>;
    static constexpr std::size_t lanes = Balls<N>::lanes;

    void add(const Solid<N>& ball, std::uint32_t object) {
        open_[pending_++] = {ball.transform.translation(), std::get<Sphere<N>>(ball.shape).radius};
        object_.push_back(object);
        if (pending_ == lanes) end_group();
    }
    /// The next ball begins a new group.
    void end_group() {
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t i = 0; i < pending_; ++i) numbers_.push_back(open_[i].centre[axis]);
        for (std::size_t i = 0; i < pending_; ++i) numbers_.push_back(open_[i].radius);
        pending_ = 0;
    }
    /// After the last one: the last group is read beyond its end.
    void close() {
        numbers_.resize(numbers_.size() + lanes);
        numbers_.shrink_to_fit();
        object_.shrink_to_fit();
    }
    [[nodiscard]] std::size_t size() const { return object_.size(); }
    [[nodiscard]] std::size_t bytes() const {
        return numbers_.capacity() * sizeof(T) + object_.capacity() * sizeof(std::uint32_t);
    }

    /// Calls hit(object) for each of the balls first … last − 1, which are whole groups, that may have a crossing with
    /// 0 ≤ t ≤ reach, until it returns true.
    /// @return the ball after the one that ended it, or `last`
    template <typename OnHit>
    std::size_t each_near(const BallRay<T>& ray, T reach, std::size_t first, std::size_t last,
                          const OnHit& hit) const {
        for (; first < last; first += lanes) {
            const std::size_t count = std::min(lanes, last - first);
            unsigned near = near_of(ray, reach, &numbers_[4 * first], count) & ((1U << count) - 1U);
            for (; near != 0; near &= near - 1) {
                const auto i = std::size_t(std::countr_zero(near));
                if (hit(object_[first + i])) return first + i + 1;
            }
        }
        return last;
    }

private:
    struct Ball {
        Vec3<T> centre{0};
        T radius = T(0);
    };

    // Bit i: the Sphere kernel finds a chord of ball i, and it may lie in the range. Both of its ends are within a radius
    // of its middle; the slack is far above what a kernel's mended root, or a compound's merged crossings, may lie
    // beside them. (`numbers` has no bounds: lanes beyond the count read the next numbers.)
    [[gnu::noinline]] static unsigned near_of(const BallRay<T>& ray, T reach, const T* numbers,
                                              std::size_t count) {
        const T *cx = numbers, *cy = cx + count, *cz = cy + count, *radius = cz + count;
        constexpr T slack = limits::power_of_half<T>(limits::digits<T> / 2 - 6);
        const T widened = ray.inverse_length * (T(1) + slack);
        alignas(64) std::array<T, lanes> least;
        for (std::size_t i = 0; i < lanes; ++i) {
            const auto chord = Sphere<N>::Chord::of(ray.x - cx[i], ray.y - cy[i], ray.z - cz[i], ray.dx,
                                                    ray.dy, ray.dz, ray.dd, ray.inverse_dd, radius[i]);
            const T half = fma(radius[i], widened, slack * magnitude(chord.middle));
            least[i] = minimum(chord.squared, minimum(half + chord.middle, half + (reach - chord.middle)));
        }
        using Lanes = std::experimental::native_simd<T>;
        unsigned near = 0;
        for (std::size_t part = 0; part < lanes; part += Lanes::size()) {
            const auto positive = Lanes(&least[part], std::experimental::vector_aligned) > T(0);
            for (std::size_t i = 0; i < Lanes::size(); ++i) near |= unsigned(positive[i]) << (part + i);
        }
        return near;
    }

    std::array<Ball, lanes> open_;
    std::size_t pending_ = 0;
    std::vector<T> numbers_;
    std::vector<std::uint32_t> object_;
};

} // namespace rayscope
