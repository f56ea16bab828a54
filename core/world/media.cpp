#include "core/world/media.hpp"

#include <algorithm>
#include <numeric>

namespace rayscope {
namespace {

// Along the axis on which the boxes spread the most, fewest overlap in that axis alone.
int widest_axis(std::span<const MediumExtent> extents) {
    Box<double> all;
    for (const auto& extent : extents)
        if (extent.box.bounded()) all = united(all, extent.box);
    const Vec3d size = all.high - all.low;
    return size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
}

// Balls that rounding may bring to touch do.
bool may_share_a_point(const MediumExtent& a, const MediumExtent& b) {
    if (!a.box.overlaps(b.box)) return false;
    if (!a.is_ball || !b.is_ball) return true;
    constexpr double rounding = 0x1p-10;                                  // far above it
    const Vec3d size = a.box.high - a.box.low + (b.box.high - b.box.low); // of both diameters
    const Vec3d apart = a.box.low + a.box.high - (b.box.low + b.box.high);
    return length(apart) <= size.x + rounding * (a.reach + b.reach);
}

} // namespace

MediaNeighbours::MediaNeighbours(std::vector<std::uint32_t> transmitting, std::vector<MediumExtent> extents)
    : all_(std::move(transmitting)), extents_(std::move(extents)), every_place_(all_.size()) {
    std::iota(every_place_.begin(), every_place_.end(), 0U);
    std::vector<Box<double>> boxes;
    for (const MediumExtent& extent : extents_) {
        boxes.push_back(extent.box);
        farthest_ = maximum(farthest_, extent.reach);
    }
    tree_ = PointTree(boxes);
    const int axis = widest_axis(extents_);
    std::vector<std::uint32_t> order = every_place_;
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return extents_[a].box.low[axis] < extents_[b].box.low[axis]; });

    std::vector<std::vector<std::uint32_t>> found(all_.size());
    std::vector<std::uint32_t> open; // boxes that the sweep is in; crowded ones need no more looking at
    for (const std::uint32_t next : order) {
        std::erase_if(open, [&](auto other) {
            return found[other].size() >= crowd ||
                   extents_[other].box.high[axis] < extents_[next].box.low[axis];
        });
        for (const std::uint32_t other : open) {
            if (found[next].size() >= crowd) break;
            if (!may_share_a_point(extents_[next], extents_[other])) continue;
            found[next].push_back(other);
            found[other].push_back(next);
        }
        open.push_back(next);
    }
    starts_.reserve(all_.size() + 1);
    starts_.push_back(0);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i].size() >= crowd)
            crowded_.push_back(std::uint32_t(i));
        else
            neighbours_.insert(neighbours_.end(), found[i].begin(), found[i].end());
        starts_.push_back(std::uint32_t(neighbours_.size()));
    }
}

std::span<const std::uint32_t> MediaNeighbours::own(std::uint32_t object) const {
    const auto at = std::lower_bound(all_.begin(), all_.end(), object);
    const auto index = std::size_t(at - all_.begin());
    if (at == all_.end() || *at != object ||
        std::binary_search(crowded_.begin(), crowded_.end(), std::uint32_t(index)))
        return every_place_;
    return std::span(neighbours_).subspan(starts_[index], starts_[index + 1] - starts_[index]);
}

} // namespace rayscope
