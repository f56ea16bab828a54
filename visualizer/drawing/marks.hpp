#pragma once
// What is written into the view: the eye, the lights, the hits' and the objects' names.

#include "visualizer/drawing/labels.hpp"
#include "visualizer/drawing/surfaces.hpp"

namespace rayscope::drawing {

/// A light or an eye outside the picture becomes an arrow at its border, with the distance: it never shrinks the
/// scene.
void draw_marks(Canvas& canvas, LabelPlacer& placer, const Trace& trace, const std::vector<RayStyle>& styles,
                const Surfaces& surfaces, const Workbench& bench, const Region& region, const View& view,
                double font);

} // namespace rayscope::drawing
