#pragma once
// Which of many boxes hold a point.

#include "core/boxes/box_tree.hpp"

#include <bit>

namespace rayscope {

class PointTree {
public:
    PointTree() = default;
    explicit PointTree(std::span<const Box<double>> boxes);

    /// Calls found(index) for each box that the point lies in or is nearer to than `margin`, and perhaps for some that float
    /// can't tell from those.
    template <typename Found> void each_at(const Vec3d& point, double margin, const Found& found) const {
        for (const std::uint32_t index : unbounded_) found(index);
        if (nodes_.empty()) return;
        const Box<float> around = around_point(point, margin);
        std::array<std::uint32_t, Node8::most_ahead> ahead;
        std::size_t top = 0;
        ahead[top++] = 0; // the root
        while (top > 0) {
            const Node8& node = nodes_[ahead[--top]];
            for (unsigned left = met(node, around); left != 0; left &= left - 1) {
                const std::uint32_t child = node.child[std::size_t(std::countr_zero(left))];
                if ((child & Node8::leaf) != 0)
                    found(child & ~Node8::leaf);
                else
                    ahead[top++] = child;
            }
        }
    }

private:
    [[nodiscard]] Box<float> around_point(const Vec3d& point, double margin) const;
    [[nodiscard]] static unsigned met(const Node8& node, const Box<float>& box);

    std::vector<Node8> nodes_; // each leaf is one box
    std::vector<std::uint32_t> unbounded_;
    double scale_ = 1;
};

} // namespace rayscope
