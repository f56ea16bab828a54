#include "core/boxes/point_tree.hpp"

namespace rayscope {

PointTree::PointTree(std::span<const Box<double>> boxes) {
    double size = 0;
    for (const auto& box : boxes)
        if (box.bounded()) size = maximum(size, largest_coordinate(box));
    scale_ = tree_scale(size);
    std::vector<BoxedItem> items;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (boxes[i].bounded())
            items.push_back({scaled_outward(boxes[i], scale_), i});
        else
            unbounded_.push_back(i);
    }
    nodes_ =
        BoxTreeBuilder(std::move(items), {1}, [](auto leaf) { return leaf.front().index; }).build().nodes;
}

Box<float> PointTree::around_point(const Vec3d& point, double margin) const {
    const Vec3d scaled = scale_ * point;
    const double reach = scale_ * margin + double(epsilon<float>) * largest_component(absolute(scaled));
    return {as<float>(scaled - Vec3d{reach}), as<float>(scaled + Vec3d{reach})};
}

unsigned PointTree::met(const Node8& node, const Box<float>& box) {
    const auto meets = [&](int axis) {
        const auto at = std::size_t(axis);
        return (EightFloats(node.low[at].data(), std::experimental::vector_aligned) <= box.high[axis]) &
               (EightFloats(node.high[at].data(), std::experimental::vector_aligned) >= box.low[axis]);
    };
    return bits_of(meets(0) & meets(1) & meets(2));
}

} // namespace rayscope
