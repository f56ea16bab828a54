#pragma once
// From a world to its tree.

#include "core/boxes/box_tree.hpp"
#include "core/bvh/bvh.hpp"

namespace rayscope {

/// Sorts the objects of a world into a tree of boxes and the bins of its leaves.
template <Numbers N> class BvhBuilder {
public:
    BvhBuilder(const World<N>& world, Bvh<N>& tree) : world_(world), tree_(tree) {}

    void build();

private:
    [[nodiscard]] std::vector<BoxedItem> sort_out();
    [[nodiscard]] bool is_mesh(const Object& object) const;
    /// Where each node and leaf hangs: recording alone asks.
    void note_places();
    [[nodiscard]] std::uint32_t make_leaf(std::span<const BoxedItem> items);

    const World<N>& world_;
    Bvh<N>& tree_;
    std::vector<std::uint32_t> objects_of_leaf_;
};

extern template class BvhBuilder<double>;

} // namespace rayscope
