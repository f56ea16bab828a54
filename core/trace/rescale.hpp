#pragma once
// Rays given by hand may have directions of any length.

#include "core/trace/trace.hpp"

namespace rayscope {

/// The power of two that brings a direction to a length whose square neither under- nor overflows; 1 for any ordinary
/// one. Multiplying by it rounds nothing.
template <Scalar T = double> [[nodiscard]] double ordinary_scale(const Vec3d& direction);

/// Undoes it in what was recorded of a ray traced with direction · scale: its t are those of the direction as given.
void rescale(TracedRay& ray, double scale);

} // namespace rayscope
