#pragma once
// Which boxes go together: where a ray that meets one is likely to meet the others.

#include "core/boxes/node8.hpp"

#include <functional>
#include <span>
#include <vector>

namespace rayscope {

/// What the tree is made of: a box, already scaled, and whose it is.
struct BoxedItem {
    Box<float> box;
    std::uint32_t index;
    float cost = 1; ///< of a test of it
};

/// What a leaf holds at most; one item always.
struct LeafLimits {
    std::size_t items;
    float cost = infinity<float>; ///< of all together
};

struct BoxTree {
    std::vector<Node8> nodes; ///< nodes[0] is the root; none where there were no items
    int depth = 0;
};

/// A power of two that brings coordinates up to `size` below 2.
[[nodiscard]] double tree_scale(double size);
/// The box scaled and rounded outward.
[[nodiscard]] Box<float> scaled_outward(const Box<double>& box, double scale);

/// The surface area heuristic (Goldsmith and Salmon 1987; binned: Wald 2007): a ray through a convex box goes through one
/// within it with a chance of the ratio of their surfaces. Of all ways to part a set between bins of its centres the
/// one with the least area · cost is taken; the widest part is divided again until a node has eight.
class BoxTreeBuilder {
public:
    /// Gives the items of a leaf a number, below Node8::leaf.
    using MakeLeaf = std::function<std::uint32_t(std::span<const BoxedItem>)>;

    BoxTreeBuilder(std::vector<BoxedItem> items, const LeafLimits& limits, MakeLeaf make_leaf)
        : items_(std::move(items)), limits_(limits), make_leaf_(std::move(make_leaf)) {}

    [[nodiscard]] BoxTree build();

private:
    /// A range of items_, with the box around them.
    struct Part {
        std::size_t first = 0, last = 0;
        Box<float> box;
        float cost = 0;

        [[nodiscard]] std::size_t size() const { return last - first; }
    };
    struct Cut {
        int axis = -1;
        float place = 0, cost = std::numeric_limits<float>::infinity();
    };

    [[nodiscard]] Part part(std::size_t first, std::size_t last) const;
    [[nodiscard]] bool fits_a_leaf(const Part& part) const {
        return part.size() <= 1 || (part.size() <= limits_.items && part.cost <= limits_.cost);
    }
    [[nodiscard]] Cut best_cut(const Part& whole) const;
    [[nodiscard]] std::size_t divide(const Part& whole, int depth);
    [[nodiscard]] std::uint32_t make(const Part& whole, int depth);

    std::vector<BoxedItem> items_;
    LeafLimits limits_;
    MakeLeaf make_leaf_;
    BoxTree tree_;
};

} // namespace rayscope
