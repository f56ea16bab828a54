#pragma once
// What is left of a surface.

#include "visualizer/page/tessellate.hpp"

#include <functional>

namespace rayscope::page {

/// The part of a surface where `value` is negative: triangles across its border are cut where it is zero.
[[nodiscard]] Triangles clipped(const Triangles& whole, const std::function<double(const Vec3d&)>& value);

/// The surface of a compound: of each leaf what its siblings on the way to the root leave of it.
/// @param compound index into Scene::compounds
[[nodiscard]] Triangles compound_surface(const Scene& scene, std::size_t compound, int around,
                                         const Ball& shown);

} // namespace rayscope::page
