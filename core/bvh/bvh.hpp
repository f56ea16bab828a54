#pragma once
// Objects in boxes, boxes in boxes.

#include "core/boxes/slab_ray.hpp"
#include "core/boxes/walk8.hpp"
#include "core/stage/bins.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/search.hpp"
#include "core/stage/unboxed.hpp"

namespace rayscope {

struct BvhStatistics {
    std::size_t nodes = 0, leaves = 0;
    std::size_t apart = 0; ///< objects without end, or a lone mesh: see Unboxed
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

    /// Records a walk.
    template <typename Search> struct Record {
        const Bvh& bvh;
        Search& search;

        void node(std::uint32_t number) const { search.recorder().record(bvh.entered(number, search.ray())); }
        void left_out() const { search.leave_out(); }
    };
    [[nodiscard]] PlaceEntered entered(std::uint32_t child, const Ray<T>& ray) const;

    std::vector<Node8> nodes_;
    std::vector<std::uint32_t> places_of_nodes_, places_of_leaves_; // 8 · node + place, where each hangs
    Bins<N> bins_;                                                  // of the leaves
    Unboxed<N> apart_;
    std::vector<std::uint32_t> all_; // bounded ones, for rays that no box can be relied on for
    double scale_ = 1, distortion_ = 3;
    BvhStatistics statistics_;
};

template <Numbers N>
template <typename Search>
void Bvh<N>::look(const RayUse& /*use*/, Search& search) const {
    if (apart_.test(search)) return;
    if (nodes_.empty()) return;
    const GroupRay group_ray = bins_.ray(search.ray());
    if (!group_ray.reliable()) {
        for (const std::uint32_t object : all_)
            if (search.test(object)) return;
        return;
    }
    const Ray8 ray(as<double>(search.ray()), scale_, distortion_);
    Counters& counters = search.work().counters;
    const auto reach = [&] { return ray.reach(double(search.reach())); };
    const auto visit = [&](std::uint32_t bin) {
        ++counters.cells;
        return bins_.each(bin, group_ray, double(search.reach()), counters,
                          [&](std::uint32_t object) { return search.test(object); });
    };
    if constexpr (Search::recording) {
        const auto recorded_visit = [&](std::uint32_t bin) {
            search.recorder().record(entered(bin | Node8::leaf, search.ray()));
            const std::uint64_t before = counters.objects;
            const bool done = visit(bin);
            search.recorder().record(place_left(before, counters.objects, bins_.held(bin)));
            return done;
        };
        walk8(nodes_, ray, reach, counters.nodes, recorded_visit, Record<Search>{*this, search});
    } else {
        walk8(nodes_, ray, reach, counters.nodes, visit);
    }
}

template <Numbers N> PlaceEntered Bvh<N>::entered(std::uint32_t child, const Ray<T>& ray) const {
    const bool is_leaf = (child & Node8::leaf) != 0;
    const std::uint32_t number = child & ~Node8::leaf;
    const auto box_of = [&](const Node8& node, std::size_t place) {
        Box<T> box;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[int(axis)] = T(double(node.low[axis][place]) / scale_);
            box.high[int(axis)] = T(double(node.high[axis][place]) / scale_);
        }
        return box;
    };
    Box<T> box;
    int level = 0;
    if (!is_leaf && number == 0) {
        for (std::size_t i = 0; i < 8; ++i) box = united(box, box_of(nodes_[0], i));
    } else {
        std::uint32_t place = (is_leaf ? places_of_leaves_ : places_of_nodes_)[number];
        box = box_of(nodes_[place / 8], place % 8);
        for (level = 1; place / 8 != 0; ++level) place = places_of_nodes_[place / 8];
    }
    const int held =
        is_leaf ? int(bins_.held(number))
                : int(std::ranges::count_if(nodes_[number].low[0], [](float x) { return is_finite(x); }));
    const BoxSpan<T> inside = SlabRay<T>(ray, T(2 / scale_), T(distortion_ + Ray8::own_distortion)).span(box);
    return place_entered(is_leaf ? PlaceKind::cell : PlaceKind::node, Id(number), level, held, box,
                         inside.enter, maximum(inside.enter, inside.exit));
}

} // namespace rayscope
