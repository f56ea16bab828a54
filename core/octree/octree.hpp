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

    template <typename Search> [[gnu::noinline]] void look(const RayUse&, Search& search) const;

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
    // Seen in the direction of the ray: where it runs down an axis the halves change places.
    const auto planes = [&](T low, T high, T origin, T per_length) {
        const T a = (low - slabs.margin() - origin) * per_length,
                b = (high + slabs.margin() - origin) * per_length;
        return std::pair{minimum(a, b), maximum(a, b)};
    };
    const auto [x0, x1] = planes(bounds_.low.x, bounds_.high.x, slabs.origin().x, inverse.x);
    const auto [y0, y1] = planes(bounds_.low.y, bounds_.high.y, slabs.origin().y, inverse.y);
    const auto [z0, z1] = planes(bounds_.low.z, bounds_.high.z, slabs.origin().z, inverse.z);
    const unsigned mirror =
        unsigned(inverse.x < T(0)) | unsigned(inverse.y < T(0)) << 1U | unsigned(inverse.z < T(0)) << 2U;
    const Vec3<T> margin = slabs.margin() * absolute(inverse);
    const auto enter = [](const Step& s) { return maximum(maximum(s.near.x, s.near.y), s.near.z); };
    const auto exit = [](const Step& s) { return minimum(minimum(s.far.x, s.far.y), s.far.z); };
    stack[0] = {0, {x0, y0, z0}, {x1, y1, z1}};
    std::size_t top = enter(stack[0]) <= exit(stack[0]) && exit(stack[0]) >= T(0) ? 1 : 0;
    T reach = search.reach();
    while (top > 0) {
        const Step step = stack[--top];
        if (!(enter(step) <= reach)) continue;
        const Node& node = nodes_[step.node];
        if (node.leaf) {
            ++search.work().counters.cells;
            if (visit(search, leaves_[node.first], ball_ray)) return true;
            reach = search.reach();
            continue;
        }
        ++search.work().counters.nodes;
        const Vec3<T> middle = (step.near + step.far) / T(2);
        const Vec3<T> to_middle = middle + margin, from_middle = middle - margin;
        // The part of each half that counts, axis by axis; then the eight parts, the nearest pushed last.
        const std::array<T, 2> xs{step.near.x, from_middle.x}, xe{to_middle.x, step.far.x};
        const std::array<T, 2> ys{step.near.y, from_middle.y}, ye{to_middle.y, step.far.y};
        const std::array<T, 2> zs{step.near.z, from_middle.z}, ze{to_middle.z, step.far.z};
        const std::array<T, 2> from{maximum(zs[0], T(0)), maximum(zs[1], T(0))},
            to{minimum(ze[0], reach), minimum(ze[1], reach)};
        for (unsigned i = 8; i-- > 0;) {
            const unsigned child = i ^ mirror;
            if ((node.occupied >> child & 1U) == 0) continue;
            const std::size_t x = i & 1U, y = i >> 1U & 1U, z = i >> 2U;
            if (maximum(maximum(xs[x], ys[y]), from[z]) <= minimum(minimum(xe[x], ye[y]), to[z]))
                stack[top++] = {node.first + child, {xs[x], ys[y], zs[z]}, {xe[x], ye[y], ze[z]}};
        }
    }
    return false;
}

} // namespace rayscope
