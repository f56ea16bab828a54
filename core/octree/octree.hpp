#pragma once
// Space cut into eight, and each part into eight again, where there is anything in it.

#include "core/octree/limits.hpp"
#include "core/stage/bins.hpp"
#include "core/stage/search.hpp"
#include "core/stage/slab_ray.hpp"

namespace rayscope {

/// An octree in world space. (After the projection, where the notes put it, angles are others, and what lies behind the
/// eye is nowhere: a mirrored ray could not use it.) A cell lists the objects whose surface may pass through it; an object
/// without end, or one whose matrix distorts so much that rounding could carry its crossings far, is kept apart and
/// tested by every ray.
template <Numbers N> class Octree : public StageBase<N, Octree<N>> {
public:
    using T = ScalarOf<N>;

    explicit Octree(const World<N>& world, const OctreeLimits& limits = {});

    template <typename Search> void look(const RayUse&, Search& search) const;

    [[nodiscard]] const OctreeStatistics& statistics() const { return statistics_; }
    [[nodiscard]] const Box<T>& bounds() const { return bounds_; }

private:
    template <Numbers> friend class OctreeBuilder;

    /// An inner node has eight neighbours in `nodes_` for children, from `first` on; child 4z + 2y + x is the upper half
    /// along the axes of its bits. A leaf has a bin.
    struct Node {
        std::uint32_t first = 0;
        std::uint8_t occupied = 0; ///< bit i: child i holds anything
        bool leaf = true;
    };
    /// A node on the way of a ray, with the t of its planes, axis by axis: nearer ones, farther ones.
    struct Step {
        std::uint32_t node;
        Vec3<T> near, far;
    };

    template <typename Search> bool walk(Search& search, const SlabRay<T>& slabs) const;
    template <typename Search> bool visit(Search& search, const Bin& bin, const BallRay<T>& ray) const;

    std::vector<Node> nodes_;
    std::vector<Bin> leaves_;
    Bins<N> bins_;
    std::vector<std::uint32_t> apart_; // tested by every ray
    std::vector<std::uint32_t> all_;   // bounded ones, for rays that no box can be relied on for
    Box<T> bounds_;
    T size_ = T(0), distortion_ = T(3);
    OctreeStatistics statistics_;
};

template <Numbers N>
template <typename Search>
void Octree<N>::look(const RayUse& /*use*/, Search& search) const {
    for (const std::uint32_t object : apart_)
        if (search.test(object)) return;
    if (nodes_.empty()) return;
    const SlabRay<T> slabs(search.ray(), size_, distortion_);
    if (slabs.reliable()) {
        search.work().mailbox.open(this->world_.objects.size());
        walk(search, slabs);
        return;
    }
    for (const std::uint32_t object : all_)
        if (search.test(object)) return;
}

template <Numbers N>
template <typename Search>
bool Octree<N>::visit(Search& search, const Bin& bin, const BallRay<T>& ray) const {
    Work<T>& work = search.work();
    return bins_.each(bin, ray, work.counters, [&](std::uint32_t object) {
        return work.mailbox.first_visit(object) && search.test(object);
    });
}

// Nearest cells first. A hit is kept wherever it lies; cells that begin beyond it are not looked at. (Who accepts a hit
// in the present cell only loses it where a surface touches a cell's face and rounding puts it on the other side.)
template <Numbers N>
template <typename Search>
bool Octree<N>::walk(Search& search, const SlabRay<T>& slabs) const {
    const BallRay<T> ball_ray(search.ray());
    const Vec3<T>& inverse = slabs.inverse();
    std::array<Step, 7 * OctreeLimits::deepest + 8> stack;
    int top = 0;
    // Seen in the direction of the ray: where it runs down an axis the halves change places.
    unsigned mirror = 0;
    Step root{0, {}, {}};
    Vec3<T> margin;
    for (int axis = 0; axis < 3; ++axis) {
        const T a = (bounds_.low[axis] - slabs.margin() - slabs.origin()[axis]) * inverse[axis];
        const T b = (bounds_.high[axis] + slabs.margin() - slabs.origin()[axis]) * inverse[axis];
        if (inverse[axis] < T(0)) mirror |= 1U << axis;
        root.near[axis] = minimum(a, b);
        root.far[axis] = maximum(a, b);
        margin[axis] = slabs.margin() * magnitude(inverse[axis]);
    }
    const auto enter = [](const Step& s) { return maximum(maximum(s.near.x, s.near.y), s.near.z); };
    const auto exit = [](const Step& s) { return minimum(minimum(s.far.x, s.far.y), s.far.z); };
    const auto counts = [&](T from, T to) { return from <= to && to >= T(0) && from <= search.reach(); };
    if (!counts(enter(root), exit(root))) return false;
    stack[std::size_t(top++)] = root;
    while (top > 0) {
        const Step step = stack[std::size_t(--top)];
        if (!(enter(step) <= search.reach())) continue;
        const Node& node = nodes_[step.node];
        if (node.leaf) {
            ++search.work().counters.cells;
            if (visit(search, leaves_[node.first], ball_ray)) return true;
            continue;
        }
        ++search.work().counters.nodes;
        const Vec3<T> middle = (step.near + step.far) / T(2);
        const Vec3<T> to_middle = middle + margin, from_middle = middle - margin;
        for (unsigned i = 8; i-- > 0;) { // the nearest is pushed last
            const unsigned child = i ^ mirror;
            if ((node.occupied >> child & 1U) == 0) continue;
            Step next{node.first + child, step.near, step.far};
            for (int axis = 0; axis < 3; ++axis)
                if ((i >> axis & 1U) != 0)
                    next.near[axis] = from_middle[axis];
                else
                    next.far[axis] = to_middle[axis];
            if (counts(enter(next), exit(next))) stack[std::size_t(top++)] = next;
        }
    }
    return false;
}

} // namespace rayscope
