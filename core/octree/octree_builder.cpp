#include "core/octree/octree_builder.hpp"

#include "core/boxes/box_tree.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace rayscope {
namespace {

// In the units of test_cost: what it takes to go through a node, and into a leaf. Measured.
constexpr double node_cost = 15, leaf_cost = 3;
// More objects than this, three groups of balls, are divided though it does not pay at once …
constexpr int usual_capacity = 48;
// … but more than this where there are few: they would fit into one cell, and nobody could see what an octree does.
constexpr int least_capacity = 8, objects_per_capacity = 16;
// … so many times in a row: balls that touch each other part only two levels below.
constexpr int patience = 2;
// A cell with an edge of so many times the reach of rounding still parts something.
constexpr double above_rounding = 1024;
// … and so does a cell with an edge of this share of the smallest object.
constexpr double of_smallest = 0.125;

} // namespace

template <Numbers N> void OctreeBuilder<N>::build() {
    const auto begin = std::chrono::steady_clock::now();
    sort_out();
    if (!lists_.empty()) {
        choose_limits();
        level_.push_back({no_parent, 0, 0, tree_.whole_, tree_.bounds_, 0, lists_.size()});
    } else {
        limits_ = wanted_;
        OctreeReasons& reasons = tree_.statistics_.reasons;
        reasons.depth = reasons.capacity = reasons.least_size = "no object fits into a cell";
    }
    for (level_depth_ = 0; !level_.empty(); ++level_depth_) {
        next_level_.clear();
        next_lists_.clear();
        for (const Open& open : level_) settle(open);
        std::swap(level_, next_level_);
        std::swap(lists_, next_lists_);
    }
    tree_.bins_.close();
    tree_.nodes_.shrink_to_fit();
    OctreeStatistics& s = tree_.statistics_;
    s.limits = limits_;
    s.nodes = tree_.nodes_.size();
    s.leaves = tree_.bins_.size();
    s.apart = tree_.apart_.size();
    s.bytes = tree_.nodes_.capacity() * sizeof(OctreeNode) + tree_.bins_.bytes() +
              tree_.all_.capacity() * sizeof(std::uint32_t);
    s.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

// The whole is a cube from the lowest corner on: what is flat then lies at its border, and no division cuts it in two.
template <Numbers N> void OctreeBuilder<N>::sort_out() {
    std::vector<std::uint32_t> apart;
    const Reach reach = rayscope::sort_out(world_, apart, tree_.all_);
    tree_.apart_ = Unboxed<N>(world_, apart);
    const double size = reach.size();
    tree_.bounds_ = reach.bounds;
    if (!tree_.all_.empty())
        tree_.whole_ = {tree_.bounds_.low, largest_component(tree_.bounds_.high - tree_.bounds_.low)};
    tree_.size_ = size + tree_.whole_.edge;
    tree_.distortion_ = reach.distortion;
    tree_.bins_.set_scale(tree_scale(tree_.size_));
    lists_ = tree_.all_;
    parts_.prepare(lists_, 64 * epsilon<double> * tree_.size_);
}

template <Numbers N> void OctreeBuilder<N>::choose_limits() {
    const double edge = tree_.whole_.edge,
                 rounding = 64 * epsilon<double> * tree_.size_ * tree_.distortion_ / 3;
    double smallest = edge;
    for (const std::uint32_t id : lists_) {
        const Box<double> box = parts_.bounds_of(id);
        smallest = minimum(smallest, largest_component(box.high - box.low));
    }
    limits_ = wanted_;
    OctreeReasons& reasons = tree_.statistics_.reasons;
    reasons.depth = reasons.capacity = reasons.least_size = "as asked for";
    if (limits_.depth == 0) {
        const double times = edge / (above_rounding * rounding);
        limits_.depth = times > 1 ? std::min(int(std::log2(times)), OctreeLimits::deepest) : 0;
        reasons.depth = limits_.depth == OctreeLimits::deepest
                            ? "no ray needs more"
                            : "smaller cells are not told from each other by coordinates of this size";
    }
    if (limits_.capacity == 0) {
        limits_.capacity =
            std::clamp(int(std::min(lists_.size() / objects_per_capacity, std::size_t(usual_capacity))),
                       least_capacity, usual_capacity);
        reasons.capacity =
            "more are divided, fewer where a ray saves more than it takes to go through the parts";
    }
    if (!(limits_.least_size > 0)) {
        limits_.least_size = edge > 0 ? of_smallest * smallest / edge : 1;
        reasons.least_size = fmt::format("{} of the smallest object", of_smallest);
    }
    // Whatever is asked for, memory grows with the number of objects alone.
    most_nodes_ = 512 + 4 * lists_.size();
    most_entries_ = 4096 + 16 * lists_.size();
}

template <Numbers N> bool OctreeBuilder<N>::must_end(const Open& open) const {
    if (open.count <= std::size_t(limits_.capacity) && wanted_.capacity != 0) return true;
    if (level_depth_ >= limits_.depth || tree_.nodes_.size() >= most_nodes_) return true;
    return std::ldexp(1.0, -level_depth_) <= limits_.least_size;
}

// The surface area heuristic: a ray through an extent goes through one within it with a chance of the ratio of their
// surfaces.
template <Numbers N> bool OctreeBuilder<N>::pays(const Open& open) const {
    double whole = leaf_cost, divided = 0;
    for (const std::uint32_t id : objects_of(open)) whole += parts_.cost_of(id);
    for (const auto& part : parts_.parts())
        if (!part.objects.empty()) divided += (leaf_cost + part.cost) * half_area(part.extent);
    return node_cost + divided / half_area(open.extent) < whole;
}

template <Numbers N> void OctreeBuilder<N>::settle(const Open& open) {
    if (must_end(open)) return make_leaf(open);
    parts_.share(objects_of(open), open.cell);
    // As many as there would be: in leaves, in what was divided on this level, and in what still waits on it.
    std::size_t sum =
        tree_.statistics_.entries + next_lists_.size() + lists_.size() - open.first - open.count;
    for (const auto& part : parts_.parts()) sum += part.objects.size();
    if (sum > most_entries_) return make_leaf(open);
    if (wanted_.capacity != 0 || pays(open)) return divide(open, 0);
    if (open.count > std::size_t(limits_.capacity) && open.unpaid < patience)
        return divide(open, open.unpaid + 1);
    make_leaf(open);
}

template <Numbers N> void OctreeBuilder<N>::divide(const Open& open, int unpaid) {
    const auto index = std::uint32_t(tree_.nodes_.size());
    OctreeNode& node = tree_.nodes_.emplace_back();
    if (open.parent == no_parent) {
        tree_.root_ = index;
    } else {
        OctreeNode& parent = tree_.nodes_[open.parent];
        if (parent.divided == 0) parent.first_node = index;
        parent.divided |= std::uint8_t(1U << open.child);
    }
    for (unsigned child = 0; child < 8; ++child) {
        const auto& part = parts_.parts()[child];
        if (part.objects.empty()) continue;
        node.set_extent(child, open.cell, part.extent);
        next_level_.push_back({index, child, unpaid, open.cell.part(child), part.extent, next_lists_.size(),
                               part.objects.size()});
        next_lists_.insert(next_lists_.end(), part.objects.begin(), part.objects.end());
    }
}

// The parts of one node come one after the other, and so do their leaves.
template <Numbers N> void OctreeBuilder<N>::make_leaf(const Open& open) {
    const std::uint32_t leaf = tree_.bins_.add(world_, objects_of(open));
    if (open.parent == no_parent) {
        tree_.root_ = leaf | Octree<N>::leaf;
    } else {
        OctreeNode& parent = tree_.nodes_[open.parent];
        if (parent.leaves == 0) parent.first_leaf = leaf;
        parent.leaves |= std::uint8_t(1U << open.child);
    }
    tree_.statistics_.depth = std::max(tree_.statistics_.depth, level_depth_);
    tree_.statistics_.entries += open.count;
}

template <Numbers N>
Octree<N>::Octree(const World<N>& world, const OctreeLimits& limits) : StageBase<N, Octree<N>>(world) {
    OctreeBuilder<N>(world, limits, *this).build();
}

template class OctreeBuilder<double>;
template Octree<double>::Octree(const World<double>&, const OctreeLimits&);

} // namespace rayscope
