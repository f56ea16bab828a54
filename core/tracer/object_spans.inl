#pragma once
// What each Numbers' own file instantiates (see the folder numbers).

#include "core/trace/rescale.hpp"
#include "core/tracer/object_spans.hpp"
#include "core/world/inside_list.hpp"

#include <type_traits>

namespace rayscope {

template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] SpanEnd span_end(const World<N>& world, const Ray<T>& ray, const Crossing<T>& crossing,
                               double scale) {
    SpanEnd end{Float128(crossing.t) * Float128(scale), 0, crossing.surface, crossing.entering, Vec3d{0}};
    if (!is_finite(crossing.t)) return end;
    const Solid<N>& solid = world.solids[crossing.surface.solid];
    end.error_bound = double(solid.error_bound(ray, crossing.t, crossing.surface.face)) * scale;
    end.normal = as<double>(solid.normal(ray, crossing.t, crossing.surface.face));
    if (crossing.surface.flipped) end.normal = -end.normal;
    return end;
}

template <Numbers N>
std::vector<ObjectSpan> object_spans(const World<N>& world, std::uint32_t object,
                                     const Ray<ScalarOf<N>>& ray) {
    using T = ScalarOf<N>;
    using Wide = std::conditional_t<std::is_same_v<T, float>, double, T>; // holds direction and scale
    const double scale = ordinary_scale<T>(as<double>(ray.direction));
    const Ray<T> scaled{ray.origin, as<T>(as<Wide>(ray.direction) * Wide(scale))};
    const LeavingSurface<T>* const nowhere = nullptr;
    Work<T> work;
    const auto found = crossings(world, object, scaled, nowhere, work);
    const bool volume = world.objects[object].has_volume;
    std::vector<ObjectSpan> result;
    for (std::size_t i = 0; i < found.size(); i += volume ? 2 : 1)
        result.push_back({span_end(world, scaled, found[i], scale),
                          span_end(world, scaled, found[volume ? i + 1 : i], scale)});
    return result;
}

} // namespace rayscope
