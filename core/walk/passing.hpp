#pragma once
// How a line that misses a solid passes it.

#include "core/scene/scene.hpp"

namespace rayscope {

/// The nearest that a line comes to a generic.
struct Passing {
    std::size_t generic = 0; ///< index into Scene::generics
    double t = 0;            ///< where
    double outside =
        0; ///< about its distance from the surface there, in the shape's own units; negative: inside
};

/// Of a drawn object (an index into Scene::drawn): one for each solid generic that it is made of, at most `most`.
/// Surfaces without volume have none.
[[nodiscard]] std::vector<Passing> passings(const Scene& scene, std::size_t drawn, const Ray<double>& ray,
                                            std::size_t most);

} // namespace rayscope
