#pragma once
// The objects of a cell or a leaf, put together by kind: balls side by side, then all others.

#include "core/stage/balls.hpp"

namespace rayscope {

/// Half-open ranges; those of balls begin and end at whole lanes.
struct Bin {
    std::uint32_t first_ball = 0, last_ball = 0;
    std::uint32_t first_other = 0, last_other = 0;
    std::uint32_t balls = 0; ///< without those that only fill a lane

    [[nodiscard]] std::uint32_t size() const { return balls + last_other - first_other; }
};

template <Numbers N> class Bins {
public:
    using T = ScalarOf<N>;

    /// Puts copies of these objects into a new bin.
    [[nodiscard]] Bin add(const World<N>& world, std::span<const std::uint32_t> objects) {
        Bin bin;
        bin.first_ball = std::uint32_t(balls_.size());
        bin.first_other = std::uint32_t(others_.size());
        for (const std::uint32_t object : objects) {
            if (const auto ball = deciding_ball(world, world.objects[object])) {
                balls_.add(world.solids[*ball], object);
                ++bin.balls;
            } else {
                others_.push_back(object);
            }
        }
        balls_.pad();
        bin.last_ball = std::uint32_t(balls_.size());
        bin.last_other = std::uint32_t(others_.size());
        return bin;
    }

    /// Calls visit(object) for what a ray may hit in a bin, until it returns true; so does this then. Balls that its line
    /// misses are only counted.
    template <typename Visit>
    bool each(const Bin& bin, const BallRay<T>& ray, Counters& counters, const Visit& visit) const {
        bool done = false;
        if (bin.balls > 0) {
            std::size_t met = 0;
            const std::size_t end =
                balls_.each_met(ray, bin.first_ball, bin.last_ball, [&](std::uint32_t object) {
                    ++met; // counted by its test
                    return done = visit(object);
                });
            const std::size_t unmet = std::min<std::size_t>(end - bin.first_ball, bin.balls) - met;
            counters.objects += unmet;
            counters.tests[Generic<N>(Sphere<N>{}).index()] += unmet;
        }
        for (std::uint32_t i = bin.first_other; i < bin.last_other && !done; ++i) done = visit(others_[i]);
        return done;
    }

    [[nodiscard]] std::size_t bytes() const {
        return balls_.bytes() + others_.capacity() * sizeof(std::uint32_t);
    }

private:
    Balls<N> balls_;
    std::vector<std::uint32_t> others_;
};

} // namespace rayscope
