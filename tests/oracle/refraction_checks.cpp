#include "tests/oracle/refraction_checks.hpp"

#include "core/reflection/mirror.hpp"
#include "core/refraction/snell.hpp"
#include "tests/oracle/comparison.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// The mirrored direction has no cancellation: rounding of two unit vectors and three products.
constexpr double mirror_tolerance = 16 * epsilon<double>;
// A radicand that rounding made positive: the direction grazes, and its length is off by that radicand.
constexpr double grazing_length_tolerance = 1e-6;

Fault fault_in_direction(const char* what, const Vec3d& found, const Vec3d& exact, double allowed) {
    const double error = std::hypot(found.x - exact.x, found.y - exact.y, found.z - exact.z);
    if (error <= allowed) return {};
    return text(what, ' ', hex(found), " instead of ", hex(exact), ": off by ", hex(error), ", allowed are ",
                hex(allowed));
}

Fault fault_in_refraction(const RefractionCase& exact) {
    const auto found = refract<double>(exact.direction, exact.normal, exact.speed_from, exact.speed_to);
    const Vec3d mirrored_direction = mirrored<double>(normalized(exact.direction), normalized(exact.normal));
    if (auto fault = fault_in_direction("mirrored", mirrored_direction, exact.reflected, mirror_tolerance))
        return fault;
    if (exact.decidable && found.total() != exact.total)
        return found.total() ? "total reflection where the ray is refracted"
                             : "refracted where all is reflected";
    if (found.total()) return {}; // the mirrored direction was checked above
    if (exact.refracted)
        return fault_in_direction("refracted", found.direction, *exact.refracted, exact.tolerance);
    if (std::abs(length(found.direction) - 1) <= grazing_length_tolerance) return {};
    return text("refracted direction of length ", hex(length(found.direction)));
}

} // namespace

void expect_refraction(const std::vector<RefractionCase>& cases) {
    constexpr int printed = 5;
    int wrong = 0;
    for (const RefractionCase& exact : cases) {
        const Fault fault = fault_in_refraction(exact);
        if (fault && wrong++ < printed)
            ADD_FAILURE() << *fault << "\n  in " << exact.id << "\n  direction " << hex(exact.direction)
                          << ", normal " << hex(exact.normal) << ", speeds " << hex(exact.speed_from) << ", "
                          << hex(exact.speed_to);
    }
    EXPECT_EQ(wrong, 0) << "cases wrong of " << cases.size();
}

} // namespace rayscope::test
