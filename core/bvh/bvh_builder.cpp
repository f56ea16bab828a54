#include "core/bvh/bvh_builder.hpp"

#include "core/stage/test_cost.hpp"

#include <chrono>

namespace rayscope {
namespace {

// Measured: two groups of balls or one of triangles, but one compound alone: its box, tested with seven others, costs less
// than it.
constexpr LeafLimits leaf_limits{32, 12};

} // namespace

template <Numbers N> void BvhBuilder<N>::build() {
    const auto begin = std::chrono::steady_clock::now();
    BoxTree boxes =
        BoxTreeBuilder(sort_out(), leaf_limits, [&](auto items) { return make_leaf(items); }).build();
    tree_.nodes_ = std::move(boxes.nodes);
    tree_.bins_.close();
    note_places();
    BvhStatistics& s = tree_.statistics_;
    s.depth = boxes.depth;
    s.nodes = tree_.nodes_.size();
    s.leaves = tree_.bins_.size();
    s.apart = tree_.apart_.size();
    s.bytes =
        tree_.nodes_.capacity() * sizeof(Node8) +
        (tree_.places_of_nodes_.capacity() + tree_.places_of_leaves_.capacity()) * sizeof(std::uint32_t) +
        tree_.bins_.bytes() + tree_.all_.capacity() * sizeof(std::uint32_t);
    s.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <Numbers N> void BvhBuilder<N>::note_places() {
    tree_.places_of_nodes_.resize(tree_.nodes_.size());
    tree_.places_of_leaves_.resize(tree_.bins_.size());
    for (std::size_t node = 0; node < tree_.nodes_.size(); ++node)
        for (std::size_t place = 0; place < 8; ++place) {
            if (!is_finite(tree_.nodes_[node].low[0][place])) continue;
            const std::uint32_t child = tree_.nodes_[node].child[place];
            const bool is_leaf = (child & Node8::leaf) != 0;
            (is_leaf ? tree_.places_of_leaves_ : tree_.places_of_nodes_)[child & ~Node8::leaf] =
                std::uint32_t(8 * node + place);
        }
}

template <Numbers N> std::vector<BoxedItem> BvhBuilder<N>::sort_out() {
    std::vector<std::uint32_t> apart;
    const Reach reach = rayscope::sort_out(world_, apart, tree_.all_);
    // A mesh has a tree of its own: another one above it alone would be set out for in vain.
    if (tree_.all_.size() == 1 && is_mesh(world_.objects[tree_.all_.front()])) {
        apart.push_back(tree_.all_.front());
        std::ranges::sort(apart);
        tree_.all_.clear();
    }
    tree_.apart_ = Unboxed<N>(world_, apart);
    tree_.distortion_ = reach.distortion;
    if (!tree_.all_.empty()) tree_.scale_ = tree_scale(reach.size());
    tree_.bins_.set_scale(tree_.scale_);
    std::vector<BoxedItem> items;
    items.reserve(tree_.all_.size());
    for (const std::uint32_t id : tree_.all_)
        items.push_back({scaled_outward(world_.objects[id].bounds, tree_.scale_), id,
                         float(test_cost_in_leaf(world_, world_.objects[id]))});
    return items;
}

template <Numbers N> bool BvhBuilder<N>::is_mesh(const Object& object) const {
    return !object.is_compound && std::holds_alternative<Mesh<N>>(world_.solids[object.index].shape);
}

template <Numbers N> std::uint32_t BvhBuilder<N>::make_leaf(std::span<const BoxedItem> items) {
    std::vector<std::uint32_t>& objects = objects_of_leaf_;
    objects.clear();
    for (const BoxedItem& item : items) objects.push_back(item.index);
    std::ranges::sort(objects);
    return tree_.bins_.add(world_, objects);
}

template <Numbers N> Bvh<N>::Bvh(const World<N>& world) : StageBase<N, Bvh<N>>(world) {
    BvhBuilder<N>(world, *this).build();
}

template class BvhBuilder<double>;
template Bvh<double>::Bvh(const World<double>&);

} // namespace rayscope
