#pragma once
// Dividing, level by level.

#include "core/octree/octree.hpp"
#include "core/octree/parts.hpp"

namespace rayscope {

template <Numbers N> class OctreeBuilder {
public:
    OctreeBuilder(const World<N>& world, const OctreeLimits& wanted, Octree<N>& tree)
        : world_(world), wanted_(wanted), tree_(tree), parts_(world) {}

    void build();

private:
    /// A cell whose objects are not handed on yet: a part of lists_.
    struct Open {
        std::uint32_t parent; ///< a node; none for the whole
        unsigned child;       ///< of its parts
        int unpaid;           ///< so many divisions above it, one after the other, did not pay by themselves
        Cell cell;
        Box<double> extent; ///< of what its objects have in it
        std::size_t first, count;
    };
    static constexpr std::uint32_t no_parent = ~0U;

    void sort_out();
    void choose_limits();
    void settle(const Open& open);
    void divide(const Open& open, int unpaid);
    void make_leaf(const Open& open);
    [[nodiscard]] bool must_end(const Open& open) const;
    [[nodiscard]] bool pays(const Open& open) const;
    [[nodiscard]] std::span<const std::uint32_t> objects_of(const Open& open) const {
        return {lists_.data() + open.first, open.count};
    }

    const World<N>& world_;
    OctreeLimits wanted_, limits_;
    Octree<N>& tree_;
    OctreeParts<N> parts_;
    int level_depth_ = 0;
    std::size_t most_nodes_ = 0, most_entries_ = 0;
    std::vector<std::uint32_t> lists_, next_lists_;
    std::vector<Open> level_, next_level_;
};

extern template class OctreeBuilder<double>;

} // namespace rayscope
