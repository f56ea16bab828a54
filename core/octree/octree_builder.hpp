#pragma once
// Dividing, level by level.

#include "core/octree/octree.hpp"
#include "core/stage/cover.hpp"

namespace rayscope {

template <Numbers N> class OctreeBuilder {
public:
    using T = ScalarOf<N>;

    OctreeBuilder(const World<N>& world, const OctreeLimits& wanted, Octree<N>& tree)
        : world_(world), wanted_(wanted), tree_(tree) {}

    void build();

private:
    /// A node whose objects are not handed on yet: a part of lists_.
    struct Open {
        std::uint32_t node;
        int depth;
        Box<T> cell;
        std::size_t first, count;
    };
    using Share = std::array<std::vector<std::uint32_t>, 8>;

    void sort_out();
    void choose_limits();
    void divide(const Open& open);
    void share(const Open& open);
    void share_ball(const Vec3<T>& centre, T radius, std::uint32_t object, const Open& open);
    [[nodiscard]] bool ends(const Open& open) const;
    [[nodiscard]] bool pays(std::size_t count) const;
    void make_leaf(const Open& open);
    [[nodiscard]] static Box<T> part_of(const Box<T>& cell, unsigned child);

    const World<N>& world_;
    OctreeLimits wanted_, limits_;
    Octree<N>& tree_;
    T margin_ = T(0); // by which cells overlap
    std::size_t most_nodes_ = 0;
    std::vector<std::uint32_t> lists_, next_lists_;
    std::vector<Open> level_, next_level_;
    Share share_;
    std::vector<Cover> covers_;
};

extern template class OctreeBuilder<double>;

} // namespace rayscope
