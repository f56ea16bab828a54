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

    /// Those that can contain a point of this object's surface, without itself, ascending. An object that does not
    /// transmit, or that meets very many, gets all of them.
    [[nodiscard]] std::span<const std::uint32_t> of(std::uint32_t object) const;

private:
    std::vector<std::uint32_t> all_;
    std::vector<std::uint32_t> starts_; // per entry of all_, into neighbours_
    std::vector<std::uint32_t> neighbours_;
    std::vector<bool> crowded_;
};

} // namespace rayscope
