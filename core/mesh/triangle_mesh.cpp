#include "core/mesh/triangle_mesh.hpp"

#include "core/boxes/box_tree.hpp"
#include "core/mesh/triangle_distance.hpp"

#include <algorithm>

namespace rayscope {
namespace {

constexpr std::size_t triangles_a_leaf = group_lanes;

void turn_inside_out(MeshData& mesh) {
    for (auto* corners : {&mesh.triangles, &mesh.triangle_normals})
        for (MeshData::Corners& t : *corners) std::swap(t[1], t[2]);
}

} // namespace

TriangleMesh::TriangleMesh(MeshData data) : data_(std::move(data)), hole_(find_hole(data_)) {
    if (!hole_ && signed_volume(data_) < 0) turn_inside_out(data_);
    for (const Vec3d& p : data_.positions) bounds_.include(p);
    scale_ = tree_scale(largest_coordinate(bounds_));
    std::vector<BoxedItem> items;
    items.reserve(size());
    for (std::uint32_t i = 0; i < size(); ++i)
        items.push_back({scaled_outward(data_.bounds_of(i), scale_), i});
    std::vector<std::uint32_t> members;
    const auto make_leaf = [&](std::span<const BoxedItem> leaf) {
        members.clear();
        for (const BoxedItem& item : leaf) members.push_back(item.index);
        std::ranges::sort(members);
        const auto first = std::uint32_t(groups_.size());
        for (const std::uint32_t i : members) {
            const MeshData::Corners& t = data_.triangles[i];
            groups_.add(data_.positions[t[0]], data_.positions[t[1]], data_.positions[t[2]], i, scale_);
        }
        groups_.end_group();
        return first << count_bits | std::uint32_t(leaf.size() - 1);
    };
    nodes_ = BoxTreeBuilder(std::move(items), {triangles_a_leaf}, make_leaf).build().nodes;
    groups_.close();
}

std::size_t TriangleMesh::bytes() const {
    return data_.bytes() + nodes_.capacity() * sizeof(Node8) + groups_.bytes();
}

// From so far away that the boxes' floats can't tell them apart: does the line pass by the ball around all of them?
bool TriangleMesh::may_meet_from_afar(const Ray<double>& ray) const {
    const Vec3d middle = (bounds_.low + bounds_.high) / 2.0, towards = middle - ray.origin;
    const double far = length(towards), radius = length(bounds_.high - middle);
    return !(length(cross(towards, normalized(ray.direction))) > radius + 64 * epsilon<double> * far);
}

bool TriangleMesh::any_in(const Box<double>& box) const {
    const Box<float> wanted = scaled_outward(box, scale_);
    std::vector<std::uint32_t> ahead{0};
    while (!ahead.empty()) {
        const Node8& node = nodes_[ahead.back()];
        ahead.pop_back();
        for (std::size_t i = 0; i < 8; ++i) {
            if (!node.box(i).overlaps(wanted)) continue;
            const std::uint32_t child = node.child[i];
            if ((child & Node8::leaf) == 0) {
                ahead.push_back(child);
                continue;
            }
            const std::uint32_t first = (child & ~Node8::leaf) >> count_bits;
            for (std::uint32_t k = first; k <= first + (child & count_mask); ++k)
                if (data_.bounds_of(groups_[k]).overlaps(box)) return true;
        }
    }
    return false;
}

double TriangleMesh::distance(const Vec3d& p) const {
    double nearest = infinity<double>;
    // A box's distance, rounded to float, may be off by this much; it only decides what is looked at.
    const Vec3<float> scaled = as<float>(p * scale_);
    const float slack = 4 * epsilon<float> * (largest_component(absolute(scaled)) + 2);
    std::vector<std::uint32_t> ahead{0};
    while (!ahead.empty()) {
        const Node8& node = nodes_[ahead.back()];
        ahead.pop_back();
        for (std::size_t i = 0; i < 8; ++i) {
            const Box<float> box = node.box(i);
            const Vec3<float> off =
                maximum_of(maximum_of(box.low - scaled, scaled - box.high), Vec3<float>{0});
            if (!(double(length(off) - slack) <= nearest * scale_)) continue;
            const std::uint32_t child = node.child[i];
            if ((child & Node8::leaf) == 0) {
                ahead.push_back(child);
                continue;
            }
            const std::uint32_t first = (child & ~Node8::leaf) >> count_bits;
            for (std::uint32_t k = first; k <= first + (child & count_mask); ++k) {
                const MeshData::Corners& t = data_.triangles[groups_[k]];
                nearest =
                    minimum(nearest, distance_to_triangle(p, data_.positions[t[0]], data_.positions[t[1]],
                                                          data_.positions[t[2]]));
            }
        }
    }
    return nearest;
}

} // namespace rayscope
