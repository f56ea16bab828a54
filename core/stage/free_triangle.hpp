#pragma once
// Polygons that are triangles at their place.

#include "core/world/world.hpp"

namespace rayscope {

/// The triangle that an object is, in world space; or none.
template <Numbers N>
[[nodiscard]] const Polygon<N>* free_triangle(const World<N>& world, const Object& object) {
    if (object.is_compound) return nullptr;
    const Solid<N>& solid = world.solids[object.index];
    const auto* polygon = std::get_if<Polygon<N>>(&solid.shape);
    return polygon != nullptr && polygon->vertices().size() == 3 && solid.transform.is_identity() ? polygon
                                                                                                  : nullptr;
}

} // namespace rayscope
