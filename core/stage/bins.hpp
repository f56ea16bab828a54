#pragma once
// The objects of each cell or leaf, put together by kind: balls side by side, triangles side by side, then all others.

#include "core/mesh/triangle_groups.hpp"
#include "core/stage/ball_groups.hpp"
#include "core/stage/free_triangle.hpp"

namespace rayscope {

template <Numbers N> class Bins {
public:
    using T = ScalarOf<N>;

    /// @param scale see tree_scale
    void set_scale(double scale) { scale_ = scale; }
    [[nodiscard]] GroupRay ray(const Ray<T>& ray) const { return {as<double>(ray), scale_}; }

    /// Puts copies of these objects into a new bin.
    /// @return its number: they are counted from 0
    std::uint32_t add(const World<N>& world, std::span<const std::uint32_t> objects) {
        for (const std::uint32_t object : objects) {
            if (const auto ball = deciding_ball(world, world.objects[object])) {
                balls_.add(world.solids[*ball], object, scale_);
            } else if (const auto* triangle = free_triangle(world, world.objects[object])) {
                const auto& corner = triangle->vertices();
                triangles_.add(as<double>(corner[0]), as<double>(corner[1]), as<double>(corner[2]), object,
                               scale_);
            } else {
                others_.push_back(object);
            }
        }
        balls_.end_group();
        triangles_.end_group();
        ends_.push_back(
            {std::uint32_t(balls_.size()), std::uint32_t(triangles_.size()), std::uint32_t(others_.size())});
        return std::uint32_t(ends_.size() - 2);
    }
    /// After the last one.
    void close() {
        balls_.close();
        triangles_.close();
        others_.shrink_to_fit();
        ends_.shrink_to_fit();
    }
    [[nodiscard]] std::size_t size() const { return ends_.size() - 1; }
    /// Objects in a bin.
    [[nodiscard]] std::size_t held(std::uint32_t bin) const {
        const Ends &first = ends_[bin], &last = ends_[bin + 1];
        return last.balls - first.balls + last.triangles - first.triangles + last.others - first.others;
    }

    /// Calls visit(object) for what a ray may hit in a bin with 0 ≤ t ≤ reach, until it returns true; so does this then.
    /// Balls and triangles that it can't hit are only counted.
    template <typename Visit>
    bool each(std::uint32_t bin, const GroupRay& ray, double reach, Counters& counters,
              const Visit& visit) const {
        const Ends &first = ends_[bin], &last = ends_[bin + 1];
        if (first.balls < last.balls &&
            each_near<Sphere<N>>(balls_, first.balls, last.balls, ray, reach, counters, visit))
            return true;
        if (first.triangles < last.triangles &&
            each_near<Polygon<N>>(triangles_, first.triangles, last.triangles, ray, reach, counters, visit))
            return true;
        for (std::uint32_t i = first.others; i < last.others; ++i)
            if (visit(others_[i])) return true;
        return false;
    }

    [[nodiscard]] std::size_t bytes() const {
        return balls_.bytes() + triangles_.bytes() + others_.capacity() * sizeof(std::uint32_t) +
               ends_.capacity() * sizeof(Ends);
    }

private:
    struct Ends {
        std::uint32_t balls, triangles, others;
    };

    template <typename Shape, typename OfOneKind, typename Visit>
    static bool each_near(const OfOneKind& groups, std::uint32_t first, std::uint32_t last,
                          const GroupRay& ray, double reach, Counters& counters, const Visit& visit) {
        bool done = false;
        std::size_t met = 0;
        const std::size_t end = groups.each_near(ray, reach, first, last, [&](std::uint32_t object) {
            ++met; // counted by its test
            return done = visit(object);
        });
        const std::size_t unmet = end - first - met;
        counters.objects += unmet;
        counters.tests[generic_index<N, Shape>()] += unmet;
        return done;
    }

    double scale_ = 1;
    BallGroups balls_;
    TriangleGroups triangles_;
    std::vector<std::uint32_t> others_;
    std::vector<Ends> ends_{{0, 0, 0}}; // bin i lies between entries i and i + 1
};

} // namespace rayscope
