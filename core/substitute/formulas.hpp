#pragma once
// Formulas that stand in place of the tracer's own: what a student wrote, say.

#include "core/math/ray.hpp"

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace rayscope {

/// A crossing as a boolean operation sees it.
struct FormulaHit {
    double t = 0;
    Vec3d normal{0}; ///< unit, outward
    bool entering = false;
    int source = 0; ///< which crossing it is: counted through the first operand's, then the second's
};

/// What happens at the wall of an object in air.
struct FormulaWall {
    Vec3d facing{0}; ///< the normal against the ray
    double speed_from = 1, speed_to = 1;
    bool local = false; ///< whether its local light is to be computed
    bool total = false; ///< whether the ray is reflected totally
};

/// Those that are empty stay the tracer's own. Each may throw, which ends the render or the trace. They are called by one
/// thread.
struct Formulas {
    /// Direction of the reflected ray: hit point, unit direction, unit normal against it.
    std::function<Vec3d(const Vec3d& p, const Vec3d& d, const Vec3d& n)> mirror;
    /// Unit direction of the refracted ray, nothing at total internal reflection; d and n unit, n against d.
    std::function<std::optional<Vec3d>(const Vec3d& d, const Vec3d& n, double c1, double c2)> refract;
    /// Unit normal in the world, from that in the object space of a solid with this matrix.
    std::function<Vec3d(const Vec3d& n, const Mat4d& matrix)> normal;
    /// Where the line of the ray is inside the unit sphere: at most one span.
    std::function<std::vector<std::pair<double, double>>(const Ray<double>& ray)> sphere;
    /// The crossings with A − B, from those with A and B: finite ones, ascending; who exits first comes from inside.
    std::function<std::vector<FormulaHit>(const std::vector<FormulaHit>& a, const std::vector<FormulaHit>& b)>
        difference;
    /// The ray in the object space of a solid with this matrix. Meshes keep the tracer's.
    std::function<Ray<double>(const Ray<double>& ray, const Mat4d& matrix)> to_object;
    /// At an object of this speed that lets light through, with nothing but air (speed 1) around it; d and the outward normal
    /// unit. Elsewhere the tracer decides.
    std::function<FormulaWall(const Vec3d& d, const Vec3d& outward, double speed)> wall;
    /// The share of unpolarized light that is mirrored.
    std::function<double(double speed_from, double speed_to, double cosine)> fresnel;
};

} // namespace rayscope
