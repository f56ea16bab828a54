#pragma once
// Which transmitting objects can share a point: where a ray crosses one, only these can be the medium.

#include "core/math/box.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace rayscope {

/// For each transmitting object the other transmitting objects whose extents overlap its own.
class MediaNeighbours {
public:
    MediaNeighbours() = default;
    /// @param transmitting ids of the objects with transmission > 0 and a volume, ascending
    /// @param bounds their extents, in the same order
    MediaNeighbours(std::vector<std::uint32_t> transmitting, std::span<const Box<double>> bounds);

    /// Every transmitting object, ascending.
    [[nodiscard]] std::span<const std::uint32_t> all() const { return all_; }

    /// Calls consider(other) for each object that can contain a point of this object's surface; perhaps for some that
    /// can't, perhaps twice, never for the object itself.
    template <typename Consider> void each_near(std::uint32_t object, const Consider& consider) const {
        for (const auto list : {own(object), std::span<const std::uint32_t>(crowded_)})
            for (const std::uint32_t other : list)
                if (other != object) consider(other);
    }

private:
    // What is stored for an object; all of them for one that is crowded or no medium.
    [[nodiscard]] std::span<const std::uint32_t> own(std::uint32_t object) const;

    std::vector<std::uint32_t> all_;
    std::vector<std::uint32_t> starts_; // per entry of all_, into neighbours_
    std::vector<std::uint32_t> neighbours_;
    std::vector<std::uint32_t> crowded_; // objects that meet very many: near to everything, ascending
};

} // namespace rayscope
