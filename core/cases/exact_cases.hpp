#pragma once
// The oracle's cases as typed values: inputs with exact answers. tests/oracle/README.md says what the fields mean.

#include "core/generics/generic.hpp"
#include "core/math/ray.hpp"
#include "core/trace/operation.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace rayscope {

/// An exact t: the nearest double, what it lacks, and what both lack.
struct ExactTime {
    double nearest = 0, rest = 0;
    Float128 tail = 0;

    [[nodiscard]] Float128 value() const { return Float128(nearest) + Float128(rest) + tail; }
    /// |t − exact|
    [[nodiscard]] double distance(Float128 t) const {
        return double(magnitude(t - Float128(nearest) - Float128(rest) - tail));
    }
};

/// A face that meets a bound.
struct ExactSurface {
    std::size_t leaf = 0;
    std::string face; ///< "side", "cap+", "cap-", "apex", "plane", "+x" …, "torus"
    bool flipped = false;
    std::optional<Vec3d> normal; ///< unit, outward from the result; none at the apex of a cone
};

/// One end of an exact span, or a touch.
struct ExactBound {
    ExactTime t;
    bool touch = false;
    std::vector<ExactSurface> surfaces; ///< all that meet here
    double tolerance = 0;               ///< for inputs that are off by 64 ε, through a plain inverse: tol64
    double tight_tolerance = 0;         ///< the same through a correctly rounded one: tol64_tight
    double tight_condition = 0;         ///< |error of t| ≤ K ε condition, to first order
    std::optional<double> normal_tolerance; ///< radians; known for kind `hit`
};

/// Indices into the bounds; none is unbounded.
struct ExactSpan {
    std::optional<std::size_t> enter, exit;
};

struct CaseLeaf {
    Generic<double> shape;
    Mat4d matrix{1};
};

/// One step of a postfix program.
struct CaseToken {
    Operation operation = Operation::leaf;
    std::size_t leaf = 0;
};

/// Kinds `hit` and `csg`: one line through a solid or a compound. Kind `hit` is a program of one leaf.
struct LineCase {
    std::string id;
    double epsilon = rayscope::epsilon<double>; ///< that decidability and tolerances are about
    bool is_compound = false;
    std::vector<CaseLeaf> leaves;
    std::vector<CaseToken> program;
    Ray<double> ray;
    std::vector<ExactBound> bounds;
    std::vector<ExactSpan> spans;       ///< without points
    std::vector<ExactSpan> clean_spans; ///< kind `csg`: slivers and cracks below the tolerances removed
    bool decidable = false;
    bool clean_decidable = false;
    bool in_surface = false;
    double tolerance_sum = 0;
};

/// The case as numbers of another ε must stand it: its tolerances, proportional to ε where it is decidable, brought
/// there.
[[nodiscard]] LineCase at_epsilon(LineCase exact, double epsilon);

/// Kind `refr`.
struct RefractionCase {
    std::string id;
    double epsilon = rayscope::epsilon<double>; ///< that decidability and tolerances are about
    Vec3d direction{0}, normal{0};
    double speed_from = 1, speed_to = 1;
    bool total = false, decidable = false;
    Vec3d reflected{0};
    std::optional<Vec3d> refracted;
    double tolerance = 0;                        ///< of `refracted`
    double reflectance_s = 1, reflectance_p = 1; ///< after Fresnel
    double reflectance_tolerance = 0;
};

/// A triangle of kind `tri`, and where the line meets its plane.
struct ExactTriangle {
    std::vector<Vec3d> corners;
    std::string status; ///< "interior", "edge", "vertex", "outside", "parallel", "coplanar"
    bool decidable = false;
    ExactTime t; ///< this and the next three only where the line is not parallel
    Vec3d weights{0};
    double tolerance = 0, weight_tolerance = 0;
};

/// Kind `tri`: one line and one or more triangles, which may share edges.
struct TriangleCase {
    std::string id;
    double epsilon = rayscope::epsilon<double>; ///< that decidability and tolerances are about
    std::vector<ExactTriangle> triangles;
    Mat4d matrix{1};
    Ray<double> ray;
    bool must_hit = false; ///< the line goes through one of them, or through what they share
};

/// Kind `cavity`: a ray between the mirrors x, y, z = ±1.
struct CavityCase {
    std::string id;
    int bounces = 0;
    Ray<double> ray;
    std::array<int, 3> wall_counts{}; ///< bounces on the walls of each axis
    double length = 0;                ///< of the path, in units of the first direction
    Vec3d end{0}, end_direction{0};
    double tolerance = 0; ///< of `end`, for K = 64
};

/// A part of a ray between two planes of a grid.
struct ExactSegment {
    double from = 0, to = 0;
    std::vector<std::array<int, 3>> cells; ///< that it may be counted to: several where it runs in a plane
};

/// Kind `oct`: a ray with t ≥ 0 through the cells of a grid on [−1, 1]³.
struct GridCase {
    std::string id;
    int depth = 0; ///< 2^depth cells along each axis
    Ray<double> ray;
    std::vector<ExactSegment> segments; ///< ascending; none where it misses or only touches
};

} // namespace rayscope
