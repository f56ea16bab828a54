#pragma once
// Why a ray did not look into a cell of the octree, asked again of the kernel that decided.

#include "core/octree/octree.hpp"

namespace rayscope {

struct WhyNotCell {
    enum class Reason : std::uint8_t {
        box_missed,      ///< the line is never between all six planes
        contents_missed, ///< it meets the cell, but not the box of what objects have in it, or in a cell around it
        behind,          ///< the cell lies behind the ray's origin
        beyond_reach, ///< it begins beyond the nearest hit, or the light
        looked_into,  ///< nothing kept the ray from it
    };
    Reason reason = Reason::looked_into;
    int level = 0;   ///< below the root, of the cell that was rejected: this one or one around it
    Box<double> box; ///< of this cell
    std::array<BoxSpan<double>, 3>
        between{};                ///< t for which the line is between its planes across x, y and z
    BoxSpan<double> inside{0, 0}; ///< the least of those; enter > exit: never
};

/// @param reach beyond which nothing counts: t of the hit or of the light
/// @return nothing if there is no such cell
[[nodiscard]] std::optional<WhyNotCell> why_not_cell(const Octree<double>& octree, const Ray<double>& ray,
                                                     double reach, std::uint32_t cell);

} // namespace rayscope
