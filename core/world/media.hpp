#pragma once
// Which transmitting objects can share a point: where a ray crosses one, only these can be the medium.

#include "core/boxes/point_tree.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rayscope {

/// Where a transmitting object can be.
struct MediumExtent {
    Box<double> box;
    bool is_ball = false; ///< it fills the ball in the box, and not the corners
    double reach = 0;     ///< the largest coordinate of it and of the parts that it is made of
};

/// For each transmitting object the other transmitting objects whose extents overlap its own.
class MediaNeighbours {
public:
    MediaNeighbours() = default;
    /// @param transmitting ids of the objects with transmission > 0 and a volume, ascending
    /// @param extents theirs, in the same order
    MediaNeighbours(std::vector<std::uint32_t> transmitting, std::vector<MediumExtent> extents);

    /// Every transmitting object, ascending.
    [[nodiscard]] std::span<const std::uint32_t> all() const { return all_; }

    /// Calls consider(other) for each object that can contain a point of this object's surface; perhaps for some that
    /// can't, perhaps twice, never for the object itself.
    template <typename Consider> void each_near(std::uint32_t object, const Consider& consider) const {
        each_place_near(object, [&](std::uint32_t place) { consider(all_[place]); });
    }
    /// The same of those alone that a point of the surface may lie in, or so near to: slack · (size + their reach).
    template <typename Consider>
    void each_at(std::uint32_t object, const Vec3d& point, double slack, double size,
                 const Consider& consider) const {
        const auto near = [&](std::uint32_t place) {
            if (all_[place] != object && is_near(extents_[place], point, slack, size)) consider(all_[place]);
        };
        const auto stored = own(object);
        if (stored.size() <= crowd && crowded_.empty())
            for (const std::uint32_t place : stored) near(place);
        else
            tree_.each_at(point, slack * (size + farthest_), near);
    }
    /// Calls consider(object) for each that a point may lie in, or so near to.
    template <typename Consider>
    void each_holding(const Vec3d& point, double slack, double size, const Consider& consider) const {
        tree_.each_at(point, slack * (size + farthest_), [&](std::uint32_t place) { consider(all_[place]); });
    }

private:
    // More overlaps than this are not stored: n objects in one place would need n² entries.
    static constexpr std::size_t crowd = 64;

    [[nodiscard]] static bool is_near(const MediumExtent& extent, const Vec3d& point, double slack,
                                      double size) {
        const double margin = slack * (size + extent.reach);
        for (int axis = 0; axis < 3; ++axis)
            if (point[axis] < extent.box.low[axis] - margin || point[axis] > extent.box.high[axis] + margin)
                return false;
        return true;
    }
    // Places in all_ from here on.
    template <typename Consider> void each_place_near(std::uint32_t object, const Consider& consider) const {
        for (const auto list : {own(object), std::span<const std::uint32_t>(crowded_)})
            for (const std::uint32_t place : list)
                if (all_[place] != object) consider(place);
    }
    // What is stored for an object; all of them for one that is crowded or no medium.
    [[nodiscard]] std::span<const std::uint32_t> own(std::uint32_t object) const;

    std::vector<std::uint32_t> all_;
    std::vector<MediumExtent> extents_;      // of all_
    std::vector<std::uint32_t> every_place_; // 0, 1, …
    std::vector<std::uint32_t> starts_;      // per entry of all_, into neighbours_
    std::vector<std::uint32_t> neighbours_;
    std::vector<std::uint32_t> crowded_; // objects that meet very many: near to everything, ascending
    PointTree tree_;                     // of their extents
    double farthest_ = 0;                // the largest reach
};

} // namespace rayscope
