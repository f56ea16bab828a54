#pragma once
// The objects of each cell or leaf, put together by kind: balls side by side, then all others.

#include "core/stage/ball_groups.hpp"

namespace rayscope {

template <Numbers N> class Bins {
public:
    using T = ScalarOf<N>;

    /// Puts copies of these objects into a new bin.
    /// @return its number: they are counted from 0
    std::uint32_t add(const World<N>& world, std::span<const std::uint32_t> objects) {
        for (const std::uint32_t object : objects) {
            if (const auto ball = deciding_ball(world, world.objects[object]))
                balls_.add(world.solids[*ball], object);
            else
                others_.push_back(object);
        }
        balls_.end_group();
        ends_.push_back({std::uint32_t(balls_.size()), std::uint32_t(others_.size())});
        return std::uint32_t(ends_.size() - 2);
    }
    /// After the last one.
    void close() {
        balls_.close();
        others_.shrink_to_fit();
        ends_.shrink_to_fit();
    }
    [[nodiscard]] std::size_t size() const { return ends_.size() - 1; }
    /// Objects in a bin.
    [[nodiscard]] std::size_t held(std::uint32_t bin) const {
        const Ends &first = ends_[bin], &last = ends_[bin + 1];
        return last.balls - first.balls + last.others - first.others;
    }

    /// Calls visit(object) for what a ray may hit in a bin with 0 ≤ t ≤ reach, until it returns true; so does this then.
    /// Balls that it can't hit are only counted.
    template <typename Visit>
    bool each(std::uint32_t bin, const BallRay<T>& ray, T reach, Counters& counters,
              const Visit& visit) const {
        const Ends &first = ends_[bin], &last = ends_[bin + 1];
        bool done = false;
        if (first.balls < last.balls) {
            std::size_t met = 0;
            const std::size_t end =
                balls_.each_near(ray, reach, first.balls, last.balls, [&](std::uint32_t object) {
                    ++met; // counted by its test
                    return done = visit(object);
                });
            const std::size_t unmet = end - first.balls - met;
            counters.objects += unmet;
            counters.tests[Generic<N>(Sphere<N>{}).index()] += unmet;
        }
        for (std::uint32_t i = first.others; i < last.others && !done; ++i) done = visit(others_[i]);
        return done;
    }

    [[nodiscard]] std::size_t bytes() const {
        return balls_.bytes() + others_.capacity() * sizeof(std::uint32_t) + ends_.capacity() * sizeof(Ends);
    }

private:
    struct Ends {
        std::uint32_t balls, others;
    };

    BallGroups<N> balls_;
    std::vector<std::uint32_t> others_;
    std::vector<Ends> ends_{{0, 0}}; // bin i lies between entries i and i + 1
};

} // namespace rayscope
