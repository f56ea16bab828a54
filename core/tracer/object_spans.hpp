#pragma once
// The inside list of one object on a ray's whole line, whatever numbers followed the ray.

#include "core/world/world.hpp"

namespace rayscope {

/// One end of an inside interval. The widest scalar type holds any other's t without loss.
struct SpanEnd {
    Float128 t = 0;
    double error_bound = 0; ///< of t; 0 for the textbook's formulas, which have none, and for an infinite t
    Surface surface;
    bool entering = false;
    Vec3d normal{0}; ///< unit, outward from the object; without meaning for an infinite t
};

struct ObjectSpan {
    SpanEnd enter, exit;
};

/// A surface without volume gives spans whose ends are one. The direction may have any length.
template <Numbers N>
[[nodiscard]] std::vector<ObjectSpan> object_spans(const World<N>& world, std::uint32_t object,
                                                   const Ray<ScalarOf<N>>& ray);

} // namespace rayscope
