#pragma once
// The part of the world in which something happens to the rays: what a picture shows.

#include "core/rayscope.hpp"

namespace rayscope::drawing {

/// A ball in world coordinates; the radius is positive and finite.
struct Region {
    Vec3d centre{0};
    double radius = 1;
    std::vector<Box<double>> boxes; ///< of the objects in it that rays hit

    /// How far a ray that hits nothing is drawn.
    [[nodiscard]] double open_length() const { return 1.2 * radius; }
    [[nodiscard]] bool holds(const Vec3d& point, double factor = 1) const {
        return length(point - centre) <= factor * radius;
    }
};

/// Hits and the bounded objects that they lie on, in the order of the rays' weight; what lies far outside the ones
/// before (a grazing ray's hit on the floor, a planet under the feet) does not make it larger.
/// @param drawn see drawn_objects
[[nodiscard]] Region region_of(const Trace& trace, const Workbench& bench, const std::vector<Id>& drawn);

} // namespace rayscope::drawing
