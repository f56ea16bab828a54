#include "core/world/media.hpp"

#include <algorithm>
#include <numeric>

namespace rayscope {
namespace {

// More overlaps than this are not stored: n objects in one place would need n² entries.
constexpr std::size_t crowd = 64;

// Along the axis on which the boxes spread the most, fewest overlap in that axis alone.
int widest_axis(std::span<const Box<double>> bounds) {
    Box<double> all;
    for (const auto& box : bounds)
        if (box.bounded()) all = united(all, box);
    const Vec3d size = all.high - all.low;
    return size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
}

} // namespace

MediaNeighbours::MediaNeighbours(std::vector<std::uint32_t> transmitting, std::span<const Box<double>> bounds)
    : all_(std::move(transmitting)) {
    const int axis = widest_axis(bounds);
    std::vector<std::uint32_t> order(all_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return bounds[a].low[axis] < bounds[b].low[axis]; });

    std::vector<std::vector<std::uint32_t>> found(all_.size());
    std::vector<std::uint32_t> open; // boxes that the sweep is in; crowded ones need no more looking at
    for (const std::uint32_t next : order) {
        std::erase_if(open, [&](auto other) {
            return found[other].size() >= crowd || bounds[other].high[axis] < bounds[next].low[axis];
        });
        for (const std::uint32_t other : open) {
            if (found[next].size() >= crowd) break;
            if (!bounds[next].overlaps(bounds[other])) continue;
            found[next].push_back(all_[other]);
            found[other].push_back(all_[next]);
        }
        open.push_back(next);
    }
    starts_.reserve(all_.size() + 1);
    starts_.push_back(0);
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (found[i].size() >= crowd)
            crowded_.push_back(all_[i]);
        else
            neighbours_.insert(neighbours_.end(), found[i].begin(), found[i].end());
        starts_.push_back(std::uint32_t(neighbours_.size()));
    }
}

std::span<const std::uint32_t> MediaNeighbours::own(std::uint32_t object) const {
    const auto at = std::lower_bound(all_.begin(), all_.end(), object);
    if (at == all_.end() || *at != object || std::binary_search(crowded_.begin(), crowded_.end(), object))
        return all_;
    const auto index = std::size_t(at - all_.begin());
    return std::span(neighbours_).subspan(starts_[index], starts_[index + 1] - starts_[index]);
}

} // namespace rayscope
