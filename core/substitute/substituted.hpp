#pragma once
// Images and rays by formulas that are not the tracer's own.

#include "core/math/substituted.hpp"
#include "core/scene/scene.hpp"
#include "core/substitute/formulas.hpp"
#include "core/tracer/render.hpp"

namespace rayscope {

/// One thread renders: the formulas need not be ready for more. Throws what they throw.
[[nodiscard]] RenderResult render_with(const Scene& scene, const Formulas& formulas, RenderOptions options);
[[nodiscard]] Recording record_with(const Scene& scene, const Formulas& formulas, const Ray<double>& ray);

} // namespace rayscope
