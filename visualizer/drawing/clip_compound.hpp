#pragma once
// The surface of a compound with sharp rims: each leaf is tessellated and clipped by its siblings' conditions on the
// path to the root (Roth 1982). An isosurface on a grid would round every edge.

#include "visualizer/drawing/tessellate.hpp"

namespace rayscope::drawing {

/// Compounds of more leaves than this are too dear to clip, each leaf by all others: they have no pieces.
inline constexpr std::size_t most_leaves = 200;

/// A drawn object's boundary, in world coordinates. See tessellate for the pieces.
/// @param drawn index into scene.drawn
[[nodiscard]] Pieces object_surface(const Scene& scene, std::size_t drawn, const Fineness& fineness,
                                    const Region& region);

/// What is left of `piece` where value < 0; the values are one for each of its points. Null if nothing is.
[[nodiscard]] vtkSmartPointer<vtkPolyData> kept_below_zero(const vtkSmartPointer<vtkPolyData>& piece,
                                                           const std::vector<double>& values);

/// A point of a piece.
[[nodiscard]] Vec3d point_of(vtkPolyData* piece, vtkIdType id);

} // namespace rayscope::drawing
