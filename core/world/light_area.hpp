#pragma once
// Lights that are no points.

#include "core/math/sequence.hpp"
#include "core/math/vec.hpp"

namespace rayscope {

/// The shape of a light around its position. All of its points shine alike, to all sides; together they are as bright
/// as the point light that they replace.
struct LightArea {
    enum class Shape : std::uint8_t { point, disk, rectangle, sphere };

    Shape shape = Shape::point;
    double radius = 0; ///< of a disk or a sphere
    Vec3d u{0},
        v{0}; ///< from the centre of a rectangle to the middle of two edges; of a disk unit, across its normal
    int samples = 1;

    /// Whether shadow rays go to points that differ from pixel to pixel.
    [[nodiscard]] bool is_sampled() const { return shape != Shape::point; }

    /// Where a sample lies from the light's position. A sphere's samples lie on the part of it that the point sees, in
    /// equal parts of the view; seen from within, on a disk through its centre.
    /// @param square where in the unit square; equal areas go to equal areas
    /// @param towards from the lit point to the light's position: world length
    [[nodiscard]] Vec3d offset(const SquarePoint& square, const Vec3d& towards) const;
};

} // namespace rayscope
