#include "tests/oracle/triangle_checks.hpp"

#include "tests/oracle/comparison.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

using Fault = std::optional<std::string>;

// Its corners have the unit axes for normals: what is interpolated are the barycentric weights.
Solid<double> solid_of(const ExactTriangle& triangle, const Mat4d& matrix) {
    return placed(Polygon<double>(triangle.corners, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), matrix);
}

std::optional<double> hit(const Solid<double>& solid, const Ray<double>& ray) {
    const auto found = solid.intervals(ray);
    if (found.begin() == found.end()) return std::nullopt;
    return found.begin()->enter;
}

Fault fault_in_hit(const ExactTriangle& exact, const Solid<double>& solid, const Ray<double>& ray, double t) {
    if (const double error = exact.t.distance(Float128(t)); !(error <= allowed_of(exact.tolerance)))
        return text("t ", hex(t), " is off by ", hex(error), ", allowed are ",
                    hex(allowed_of(exact.tolerance)));
    const Vec3d weights =
        std::get<Polygon<double>>(solid.shape).shading_normal(solid.transform.to_object(ray).at(t));
    if (const double error = largest_component(absolute(weights - exact.weights));
        !(error <= exact.weight_tolerance))
        return text("weights ", hex(weights), " are off by ", hex(error), ", allowed are ",
                    hex(exact.weight_tolerance));
    return {};
}

Fault fault_in_case(const TriangleCase& exact) {
    bool any = false;
    for (const ExactTriangle& triangle : exact.triangles) {
        const Solid<double> solid = solid_of(triangle, exact.matrix);
        const auto t = hit(solid, exact.ray);
        any = any || t.has_value();
        const bool along = triangle.status == "parallel" || triangle.status == "coplanar";
        if (along && t) return text("hit at ", hex(*t), " though ", triangle.status);
        if (along || !triangle.decidable) continue;
        if (t.has_value() != (triangle.status == "interior"))
            return text(t ? "hit" : "missed", " though ", triangle.status);
        if (!t) continue;
        if (auto fault = fault_in_hit(triangle, solid, exact.ray, *t)) return fault;
    }
    if (exact.must_hit && !any) return "the ray slips between the triangles";
    return {};
}

} // namespace

void expect_triangles(const std::vector<TriangleCase>& cases) {
    constexpr int printed = 5;
    int wrong = 0;
    for (const TriangleCase& exact : cases) {
        const Fault fault = fault_in_case(exact);
        if (fault && wrong++ < printed)
            ADD_FAILURE() << *fault << "\n  in " << exact.id << "\n  ray " << hex(exact.ray.origin) << ", "
                          << hex(exact.ray.direction);
    }
    EXPECT_EQ(wrong, 0) << "cases wrong of " << cases.size();
}

} // namespace rayscope::test
