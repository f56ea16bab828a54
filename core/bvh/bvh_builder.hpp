#pragma once
// Which objects go together: where a ray that meets one is likely to meet the others.

#include "core/bvh/bvh.hpp"

namespace rayscope {

/// The surface area heuristic (Goldsmith and Salmon 1987; binned: Wald 2007): a ray through a convex box goes through one
/// within it with a chance of the ratio of their surfaces. Of all ways to part a set between bins of its centres the
/// one with the least area · objects is taken; the widest part is divided again until a node has eight.
template <Numbers N> class BvhBuilder {
public:
    BvhBuilder(const World<N>& world, Bvh<N>& tree) : world_(world), tree_(tree) {}

    void build();

private:
    struct Item {
        Box<float> box;
        std::uint32_t object;
    };
    /// A range of items_, with the box around them.
    struct Part {
        std::size_t first = 0, last = 0;
        Box<float> box;

        [[nodiscard]] std::size_t size() const { return last - first; }
    };
    struct Cut {
        int axis = -1;
        float place = 0, cost = std::numeric_limits<float>::infinity();
    };

    void sort_out();
    [[nodiscard]] Part part(std::size_t first, std::size_t last) const;
    [[nodiscard]] Cut best_cut(const Part& whole) const;
    [[nodiscard]] std::size_t divide(const Part& whole, int depth);
    [[nodiscard]] std::uint32_t make(const Part& whole, int depth);
    [[nodiscard]] std::uint32_t make_leaf(const Part& whole);

    const World<N>& world_;
    Bvh<N>& tree_;
    std::vector<Item> items_;
    std::vector<std::uint32_t> objects_of_leaf_;
};

extern template class BvhBuilder<double>;

} // namespace rayscope
