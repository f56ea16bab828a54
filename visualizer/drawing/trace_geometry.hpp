#pragma once
// A trace as points and lines, in world coordinates and doubles. Pictures and .vtm files are both made of these, and
// every point is the trace's own: a hit's point as recorded, any other as origin + t·direction.

#include "core/rayscope.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace rayscope::drawing {

/// One line for each ray. Cell arrays: ray_id, parent_id, step, depth, kind, kind_name, object_name, t_hit (NaN
/// without a hit), weight, direction, open (1: goes on without end), blocked (1: a shadow ray that is stopped).
/// @param open_length world length of a ray that goes on without end
[[nodiscard]] vtkSmartPointer<vtkPolyData> rays_polydata(const Trace& trace, double open_length);

/// One vertex for each hit. Point arrays: ray_id, step, object_name, t_hit, error_bound, Normals (outward).
[[nodiscard]] vtkSmartPointer<vtkPolyData> hits_polydata(const Trace& trace);

/// One line for each inside interval that reaches t > 0, from max(enter, 0) to the exit, or for an open end to
/// `open_length`. Cell arrays: ray_id, step, object_id, node_id, node_name, t_enter, t_exit (as recorded).
[[nodiscard]] vtkSmartPointer<vtkPolyData> spans_polydata(const Trace& trace, double open_length);

/// The twelve edges of each box that a stage looked into: cells, leaves and extents, none of infinite size. Cell arrays:
/// ray_id, step, place, level, object_name (of an extent), held, t_in, t_out.
[[nodiscard]] vtkSmartPointer<vtkPolyData> places_polydata(const Trace& trace);

/// What a person calls a node: its own name, and the root its object's.
[[nodiscard]] std::string node_label(const Trace& trace, Id object, Id node);

} // namespace rayscope::drawing
