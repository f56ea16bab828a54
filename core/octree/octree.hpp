#pragma once
// Space cut into eight, and each part into eight again, where there is anything in it.

#include "core/boxes/unwatched.hpp"
#include "core/octree/node.hpp"
#include "core/stage/bins.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/search.hpp"
#include "core/stage/unboxed.hpp"

namespace rayscope {

/// An octree in world space. (After the projection, where the notes put it, angles are others, and what lies behind the
/// eye is nowhere: a mirrored ray could not use it.) A cell lists the objects whose surface may pass through it, and
/// knows the extent of what they have in it; an object without end, or one whose matrix distorts so much that rounding
/// could carry its crossings far, is kept apart (see Unboxed).
template <Numbers N> class Octree : public StageBase<N, Octree<N>> {
public:
    using T = ScalarOf<N>;

    explicit Octree(const World<N>& world, const OctreeLimits& limits = {});

    template <typename Search> [[gnu::noinline]] void look(const RayUse&, Search& search) const;

    /// Calls enter(leaf, cell) for the leaves that a ray passes, nearest first, until it returns true.
    /// @param reach called after each: what begins beyond this t is not looked at any more
    template <typename Reach, typename Enter, typename Watch = Unwatched>
    void walk(const SlabRay<double>& slabs, Counters& counters, const Reach& reach, const Enter& enter,
              const Watch& watch = {}) const;

    /// A step down from a node to a part of it.
    struct Descent {
        const OctreeNode* node;
        Cell cell; ///< the node's
        unsigned child;
    };
    /// From the root down to a leaf; nothing if there is no leaf of that number. A lone root has no steps.
    [[nodiscard]] std::optional<std::vector<Descent>> way_to(std::uint32_t wanted) const;

    [[nodiscard]] const OctreeStatistics& statistics() const { return statistics_; }
    [[nodiscard]] const Cell& whole() const { return whole_; }
    /// Made ready for walk(), if it is `reliable`.
    [[nodiscard]] SlabRay<double> slabs(const Ray<T>& ray) const {
        return {as<double>(ray), size_, distortion_};
    }

private:
    template <Numbers> friend class OctreeBuilder;

    /// Records a walk.
    template <typename Search> struct Record {
        const Octree& octree;
        const SlabRay<double>& slabs;
        Search& search;

        void place(PlaceKind kind, std::uint32_t number, std::size_t held, const Cell& cell) const {
            const BoxSpan<double> inside = slabs.span(cell.box());
            const int level = std::ilogb(octree.whole_.edge / cell.edge);
            search.recorder().record(
                place_entered(kind, Id(number), level, int(held), cell.box(), inside.enter, inside.exit));
        }
        void node(std::uint32_t number, const OctreeNode& node, const Cell& cell) const {
            place(PlaceKind::node, number, std::size_t(std::popcount(unsigned(node.divided) | node.leaves)),
                  cell);
        }
        void left_out() const { search.leave_out(); }
    };

    static constexpr std::uint32_t leaf =
        1U << 31; // set in Step::place where it is a leaf's number, not a node's
    struct Step {
        std::uint32_t place;
        std::uint16_t depth, child; ///< of the node whose part it is: that part of it
        double enter;
    };

    std::uint32_t root_ = leaf;
    std::vector<OctreeNode> nodes_;
    Bins<N> bins_; // of the leaves
    Unboxed<N> apart_;
    std::vector<std::uint32_t> all_; // bounded ones, for rays that no box can be relied on for
    Cell whole_{Vec3d{0}, 0};
    Box<double> bounds_;
    double size_ = 0, distortion_ = 3;
    OctreeStatistics statistics_;
};

template <Numbers N>
template <typename Search>
void Octree<N>::look(const RayUse& /*use*/, Search& search) const {
    if (apart_.test(search)) return;
    if (all_.empty()) return;
    const GroupRay group_ray = bins_.ray(search.ray());
    if (!group_ray.reliable()) {
        for (const std::uint32_t object : all_)
            if (search.test(object)) return;
        return;
    }
    Work<T>& work = search.work();
    work.mailbox.open(this->world_.objects.size());
    const SlabRay<double> ready = slabs(search.ray());
    const auto reach = [&] { return double(search.reach()); };
    const auto visit = [&](std::uint32_t bin) {
        return bins_.each(bin, group_ray, double(search.reach()), work.counters, [&](std::uint32_t object) {
            return work.mailbox.first_visit(object) && search.test(object);
        });
    };
    if constexpr (Search::recording) {
        const Record<Search> record{*this, ready, search};
        const auto recorded_visit = [&](std::uint32_t bin, const Cell& cell) {
            record.place(PlaceKind::cell, bin, bins_.held(bin), cell);
            const std::uint64_t before = work.counters.objects;
            const bool done = visit(bin);
            search.recorder().record(place_left(before, work.counters.objects, bins_.held(bin)));
            return done;
        };
        walk(ready, work.counters, reach, recorded_visit, record);
    } else {
        walk(ready, work.counters, reach,
             [&](std::uint32_t bin, const Cell& /*cell*/) { return visit(bin); });
    }
}

// A hit is kept wherever it lies; what begins beyond it is not looked at. (Who accepts a hit in the present cell only
// loses it where a surface touches a cell's face and rounding puts it on the other side.)
template <Numbers N>
template <typename Reach, typename Enter, typename Watch>
void Octree<N>::walk(const SlabRay<double>& slabs, Counters& counters, const Reach& reach, const Enter& enter,
                     const Watch& watch) const {
    double limit = reach();
    if (!slabs.may_hit(bounds_, limit)) {
        if (slabs.may_hit(bounds_)) watch.left_out();
        return;
    }
    const OctreeRay ray(slabs);
    // Depth first: while its parts are still to come, the cell of a node stays where it is.
    std::array<Cell, OctreeLimits::deepest + 1> cells;
    std::array<Step, 7 * OctreeLimits::deepest + 8> stack;
    std::array<double, 8> enters;
    std::size_t top = 0;
    std::uint32_t place = root_;
    std::uint32_t depth = 0;
    Cell cell = whole_;
    for (;;) {
        bool descends = false;
        unsigned child = 0;
        if ((place & leaf) != 0) {
            ++counters.cells;
            if (enter(place & ~leaf, cell)) return;
            limit = reach();
        } else {
            ++counters.nodes;
            const OctreeNode& node = nodes_[place];
            watch.node(place, node, cell);
            const unsigned filled = unsigned(node.divided) | unsigned(node.leaves);
            unsigned met = ray.in_ray_order(ray.meet(node, cell, limit, enters) & filled);
            const auto take = [&] { // the farthest of those that are left
                const auto last = unsigned(std::bit_width(met)) - 1U;
                met &= ~(1U << last);
                child = last ^ ray.mirror();
                return (node.leaves >> child & 1U) != 0 ? node.leaf_of(child) | leaf : node.node_of(child);
            };
            descends = met != 0;
            if (descends) {
                cells[depth] = cell;
                while ((met & (met - 1)) != 0) {
                    const std::uint32_t next = take();
                    if ((next & leaf) == 0) __builtin_prefetch(&nodes_[next]); // its turn comes late enough
                    stack[top++] = {next, std::uint16_t(depth), std::uint16_t(child), enters[child]};
                }
                place = take();
            }
        }
        for (; !descends; watch.left_out()) {
            if (top == 0) return;
            const Step& step = stack[--top];
            if (step.enter > limit) continue;
            place = step.place;
            depth = step.depth;
            child = step.child;
            cell = cells[depth];
            break;
        }
        cell = cell.part(child);
        ++depth;
    }
}

template <Numbers N>
std::optional<std::vector<typename Octree<N>::Descent>> Octree<N>::way_to(std::uint32_t wanted) const {
    if ((root_ & leaf) != 0) {
        if (all_.empty() || (root_ & ~leaf) != wanted) return std::nullopt;
        return std::vector<Descent>{};
    }
    std::vector<std::pair<Descent, std::size_t>> open; // with the length of the way to it
    const auto push = [&](const OctreeNode& node, const Cell& cell, std::size_t length) {
        for (unsigned child = 0; child < 8; ++child) open.push_back({{&node, cell, child}, length});
    };
    push(nodes_[root_], whole_, 0);
    std::vector<Descent> way;
    while (!open.empty()) {
        const auto [step, length] = open.back();
        open.pop_back();
        way.resize(length);
        way.push_back(step);
        if ((step.node->leaves >> step.child & 1U) != 0 && step.node->leaf_of(step.child) == wanted)
            return way;
        if ((step.node->divided >> step.child & 1U) != 0)
            push(nodes_[step.node->node_of(step.child)], step.cell.part(step.child), length + 1);
    }
    return std::nullopt;
}

} // namespace rayscope
