#pragma once
// Rays of a trace on a sheet.

#include "visualizer/figures/sheet.hpp"

namespace rayscope::figures {

/// All three throw InputError where the trace lacks what a figure shows: its scene was changed.
[[nodiscard]] const BoundaryChosen& hit_of(const Trace& trace, int ray);
[[nodiscard]] int child_of(const Trace& trace, int ray, RayKind kind);
/// The hit, or a point so far away.
[[nodiscard]] Vec3d end_point(const Trace& trace, int ray, double open_length);

/// A colour and a dash for each kind.
[[nodiscard]] Pen pen_of(RayKind kind, double width = 3);

/// An arc between two directions, and its words outside of it.
void draw_angle(Svg& svg, const Sheet& sheet, const Vec3d& at, const Vec3d& from, const Vec3d& to,
                double radius, const std::string& words, Rgb colour, double beyond);

} // namespace rayscope::figures
