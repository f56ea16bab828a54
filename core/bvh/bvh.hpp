#pragma once
// Objects in boxes, boxes in boxes.

#include "core/boxes/walk8.hpp"
#include "core/stage/bins.hpp"
#include "core/stage/search.hpp"

namespace rayscope {

struct BvhStatistics {
    std::size_t nodes = 0, leaves = 0;
    std::size_t apart = 0; ///< objects without end, tested by every ray
    int depth = 0;
    std::size_t bytes = 0;
    double build_seconds = 0;
};

/// A bounding volume hierarchy with eight children a node. Every object lies in one leaf; boxes overlap.
template <Numbers N> class Bvh : public StageBase<N, Bvh<N>> {
public:
    using T = ScalarOf<N>;

    explicit Bvh(const World<N>& world);

    template <typename Search> [[gnu::noinline]] void look(const RayUse&, Search& search) const;

    [[nodiscard]] const BvhStatistics& statistics() const { return statistics_; }

private:
    template <Numbers> friend class BvhBuilder;

    std::vector<Node8> nodes_;
    std::vector<Bin> leaves_;
    Bins<N> bins_;
    std::vector<std::uint32_t> apart_;
    std::vector<std::uint32_t> all_; // bounded ones, for rays that no box can be relied on for
    double scale_ = 1, distortion_ = 3;
    BvhStatistics statistics_;
};

template <Numbers N>
template <typename Search>
void Bvh<N>::look(const RayUse& /*use*/, Search& search) const {
    for (const std::uint32_t object : apart_)
        if (search.test(object)) return;
    if (nodes_.empty()) return;
    const Ray8 ray(as<double>(search.ray()), scale_, distortion_);
    if (!ray.reliable()) {
        for (const std::uint32_t object : all_)
            if (search.test(object)) return;
        return;
    }
    const BallRay<T> ball_ray(search.ray());
    Counters& counters = search.work().counters;
    walk8(
        nodes_, ray, [&] { return ray.reach(double(search.reach())); }, counters.nodes,
        [&](std::uint32_t leaf) {
            ++counters.cells;
            return bins_.each(leaves_[leaf], ball_ray, counters,
                              [&](std::uint32_t object) { return search.test(object); });
        });
}

} // namespace rayscope
