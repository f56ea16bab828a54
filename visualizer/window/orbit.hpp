#pragma once
// The 3D view's camera, as a person moves it: around a pivot, nearer and farther.

#include "visualizer/drawing/view.hpp"

namespace rayscope::window {

struct Orbit {
    Vec3d pivot{0};      ///< world
    double radius = 1;   ///< world length around the pivot that is seen
    Vec3d back{0, 0, 1}; ///< unit, from the pivot to the camera
    Vec3d up{0, 1, 0};   ///< unit; of the scene, not of the screen

    [[nodiscard]] drawing::View view(const drawing::Area& area) const;
    /// By so many pixels of a drag.
    void turn(double dx, double dy);
    void shift(const drawing::View& view, double dx, double dy);
    void zoom(double factor);
    /// The camera stands at `from` and looks at `to`.
    void look(const Vec3d& from, const Vec3d& to);
};

/// As the pictures see a trace.
[[nodiscard]] Orbit framed_orbit(const Trace& trace, const Scene& scene, const drawing::Region& region,
                                 const drawing::Area& area, int ray);

} // namespace rayscope::window
