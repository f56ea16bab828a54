#include "core/octree/octree_builder.hpp"

#include "core/stage/apart.hpp"

#include <chrono>

#include <fmt/format.h>

namespace rayscope {
namespace {

// Measured: smaller leaves are walked through longer than their balls take to test eight at a time.
constexpr int usual_capacity = 16;

} // namespace

template <Numbers N> void OctreeBuilder<N>::build() {
    const auto begin = std::chrono::steady_clock::now();
    sort_out();
    if (!lists_.empty()) {
        choose_limits();
        tree_.nodes_.emplace_back();
        level_.push_back({0, 0, tree_.bounds_, 0, lists_.size()});
    }
    while (!level_.empty()) {
        next_level_.clear();
        next_lists_.clear();
        for (const Open& open : level_) ends(open) ? make_leaf(open) : divide(open);
        std::swap(level_, next_level_);
        std::swap(lists_, next_lists_);
    }
    OctreeStatistics& s = tree_.statistics_;
    s.limits = limits_;
    s.nodes = tree_.nodes_.size();
    s.leaves = tree_.leaves_.size();
    s.apart = tree_.apart_.size();
    s.bytes = tree_.nodes_.capacity() * sizeof(typename Octree<N>::Node) +
              tree_.leaves_.capacity() * sizeof(Bin) + tree_.bins_.bytes();
    s.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <Numbers N> void OctreeBuilder<N>::sort_out() {
    const Reach reach = rayscope::sort_out(world_, tree_.apart_, tree_.all_);
    tree_.bounds_ = as<T>(reach.bounds);
    tree_.size_ = T(reach.size());
    tree_.distortion_ = T(reach.distortion);
    lists_ = tree_.all_;
    margin_ = T(64) * epsilon<T> * tree_.size_;
}

template <Numbers N> void OctreeBuilder<N>::choose_limits() {
    limits_ = wanted_;
    if (limits_.depth == 0) limits_.depth = OctreeLimits::deepest;
    if (limits_.capacity == 0) limits_.capacity = usual_capacity;
    // Whatever is asked for, memory grows with the number of objects alone.
    most_nodes_ = 4096 + 16 * lists_.size();
    tree_.statistics_.reason =
        wanted_.capacity == 0
            ? fmt::format("{} objects: a cell of more than {} is divided where that saves tests",
                          lists_.size(), limits_.capacity)
            : fmt::format("{} objects: a cell of more than {} is divided, as asked for", lists_.size(),
                          limits_.capacity);
}

template <Numbers N> bool OctreeBuilder<N>::ends(const Open& open) const {
    if (open.count <= std::size_t(limits_.capacity) || open.depth >= limits_.depth) return true;
    if (tree_.nodes_.size() + 8 > most_nodes_) return true;
    return limits_.least_size > 0 && std::ldexp(1.0, -open.depth) <= limits_.least_size;
}

// A ray through a cell goes through a part of it with a chance of about one in four, as the areas are; a division pays
// if the tests that it saves outweigh the walk.
template <Numbers N> bool OctreeBuilder<N>::pays(std::size_t count) const {
    if (wanted_.capacity != 0) return true;
    std::size_t sum = 0, occupied = 0;
    for (const auto& list : share_) {
        sum += list.size();
        occupied += list.empty() ? 0 : 1;
    }
    return double(sum) / 4 + double(occupied) < double(count);
}

template <Numbers N> void OctreeBuilder<N>::divide(const Open& open) {
    share(open);
    if (!pays(open.count)) {
        make_leaf(open);
        return;
    }
    const auto first = std::uint32_t(tree_.nodes_.size());
    tree_.nodes_.resize(tree_.nodes_.size() + 8);
    auto& node = tree_.nodes_[open.node];
    node.leaf = false;
    node.first = first;
    for (unsigned child = 0; child < 8; ++child) {
        const auto& list = share_[child];
        if (list.empty()) continue;
        node.occupied |= std::uint8_t(1U << child);
        next_level_.push_back(
            {first + child, open.depth + 1, part_of(open.cell, child), next_lists_.size(), list.size()});
        next_lists_.insert(next_lists_.end(), list.begin(), list.end());
    }
}

template <Numbers N>
Box<typename OctreeBuilder<N>::T> OctreeBuilder<N>::part_of(const Box<T>& cell, unsigned child) {
    Box<T> part = cell;
    for (int axis = 0; axis < 3; ++axis) {
        const T middle = (cell.low[axis] + cell.high[axis]) / T(2);
        ((child >> axis & 1U) != 0 ? part.low : part.high)[axis] = middle;
    }
    return part;
}

template <Numbers N> void OctreeBuilder<N>::share(const Open& open) {
    for (auto& list : share_) list.clear();
    std::array<Box<T>, 8> parts;
    for (unsigned child = 0; child < 8; ++child) {
        parts[child] = part_of(open.cell, child);
        parts[child].low -= margin_;
        parts[child].high += margin_;
    }
    for (std::size_t i = open.first; i < open.first + open.count; ++i) {
        const std::uint32_t id = lists_[i];
        const Object& object = world_.objects[id];
        if (world_.is_ball(object)) {
            const Solid<N>& ball = world_.solids[object.index];
            share_ball(ball.transform.translation(), std::get<Sphere<N>>(ball.shape).radius, id, open);
            continue;
        }
        const Box<T> bounds = as<T>(object.bounds);
        for (unsigned child = 0; child < 8; ++child)
            if (bounds.overlaps(parts[child]) && has_surface_in(world_, object, parts[child], covers_))
                share_[child].push_back(id);
    }
}

// cover_of for the eight parts at once: the distances from the centre, squared, add up axis by axis.
template <Numbers N>
void OctreeBuilder<N>::share_ball(const Vec3<T>& centre, T radius, std::uint32_t object, const Open& open) {
    std::array<std::array<cover::Sizes<T>, 2>, 3> squared{
        {{{{T(0), T(0)}, {T(0), T(0)}}}, {{{T(0), T(0)}, {T(0), T(0)}}}, {{{T(0), T(0)}, {T(0), T(0)}}}}};
    for (int axis = 0; axis < 3; ++axis) {
        const T low = open.cell.low[axis] - centre[axis], high = open.cell.high[axis] - centre[axis];
        const T middle = (open.cell.low[axis] + open.cell.high[axis]) / T(2) - centre[axis];
        const cover::Sizes<T> lower(low - margin_, middle + margin_), upper(middle - margin_, high + margin_);
        auto& halves = squared[std::size_t(axis)];
        halves[0].least = lower.least * lower.least;
        halves[0].most = lower.most * lower.most;
        halves[1].least = upper.least * upper.least;
        halves[1].most = upper.most * upper.most;
    }
    const T limit = radius * radius;
    for (unsigned child = 0; child < 8; ++child) {
        const auto &x = squared[0][child & 1U], &y = squared[1][child >> 1 & 1U],
                   &z = squared[2][child >> 2 & 1U];
        cover::Sizes<T> sum(T(0), T(0));
        sum.least = x.least + y.least + z.least;
        sum.most = x.most + y.most + z.most;
        if (cover::below(sum, limit) == Cover::partial) share_[child].push_back(object);
    }
}

template <Numbers N> void OctreeBuilder<N>::make_leaf(const Open& open) {
    auto& node = tree_.nodes_[open.node];
    node.leaf = true;
    node.first = std::uint32_t(tree_.leaves_.size());
    tree_.leaves_.push_back(tree_.bins_.add(world_, {&lists_[open.first], open.count}));
    tree_.statistics_.depth = std::max(tree_.statistics_.depth, open.depth);
    tree_.statistics_.entries += open.count;
}

template <Numbers N>
Octree<N>::Octree(const World<N>& world, const OctreeLimits& limits) : StageBase<N, Octree<N>>(world) {
    OctreeBuilder<N>(world, limits, *this).build();
}

template class OctreeBuilder<double>;
template Octree<double>::Octree(const World<double>&, const OctreeLimits&);

} // namespace rayscope
