#pragma once
// The oracle's cases as typed values: inputs with exact answers. What the fields mean is in README.md.

#include "core/generics/generic.hpp"
#include "core/math/ray.hpp"
#include "core/trace/operation.hpp"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rayscope::test {

/// A t to about 106 bits: the nearest double and what it lacks.
struct ExactTime {
    double nearest = 0, rest = 0;

    [[nodiscard]] long double value() const {
        return static_cast<long double>(nearest) + static_cast<long double>(rest);
    }
    /// |t − exact|
    [[nodiscard]] double distance(double t) const {
        return static_cast<double>(std::abs(static_cast<long double>(t) - static_cast<long double>(nearest) -
                                            static_cast<long double>(rest)));
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

/// Kind `refr`.
struct RefractionCase {
    std::string id;
    Vec3d direction{0}, normal{0};
    double speed_from = 1, speed_to = 1;
    bool total = false, decidable = false;
    Vec3d reflected{0};
    std::optional<Vec3d> refracted;
    double tolerance = 0;
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

/// Throw std::runtime_error "file:line: what is wrong" where a file can't be read.
[[nodiscard]] std::vector<LineCase> read_line_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<RefractionCase> read_refraction_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<TriangleCase> read_triangle_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<CavityCase> read_cavity_cases(const std::filesystem::path& path);

} // namespace rayscope::test
