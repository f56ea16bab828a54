#include "tests/oracle/refraction_checks.hpp"

#include "core/reflection/mirror.hpp"
#include "core/refraction/fresnel.hpp"
#include "core/refraction/snell.hpp"
#include "tests/oracle/comparison.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

// The mirrored direction has no cancellation: rounding of two unit vectors and three products, in ε.
constexpr double mirror_tolerance = 16;
// A radicand that rounding made positive: the direction grazes, and its length is off by that radicand, in √ε.
constexpr double grazing_length_tolerance = 64;

Fault fault_in_direction(const char* what, const Vec3d& found, const Vec3d& exact, double allowed) {
    const double error = std::hypot(found.x - exact.x, found.y - exact.y, found.z - exact.z);
    if (error <= allowed) return {};
    return text(what, ' ', hex(found), " instead of ", hex(exact), ": off by ", hex(error), ", allowed are ",
                hex(allowed));
}

// Both polarizations, in the tolerance that the files state for them.
Fault fault_in_reflectance(const RefractionCase& exact, double s, double p, double scale) {
    const double error = std::max(std::abs(s - exact.reflectance_s), std::abs(p - exact.reflectance_p));
    const double allowed = exact.reflectance_tolerance * scale;
    if (!(s >= 0 && s <= 1 && p >= 0 && p <= 1)) return text("reflects ", hex(s), " and ", hex(p));
    if (!exact.decidable || error <= allowed) return {};
    return text("reflects ", hex(s), " and ", hex(p), " instead of ", hex(exact.reflectance_s), " and ",
                hex(exact.reflectance_p), ": off by ", hex(error), ", allowed are ", hex(allowed));
}

template <Numbers N> Fault fault_in_refraction(const RefractionCase& exact) {
    using T = ScalarOf<N>;
    const Vec3<T> d = as<T>(exact.direction), n = as<T>(exact.normal);
    const T from = static_cast<T>(exact.speed_from), to = static_cast<T>(exact.speed_to);
    const auto unit = static_cast<double>(epsilon<T>);
    const double scale = unit / exact.epsilon;
    const auto found = refract<N>(d, n, from, to);
    const Vec3d mirrored_direction = as<double>(mirrored<N>(normalized(d), normalized(n)));
    if (auto fault =
            fault_in_direction("mirrored", mirrored_direction, exact.reflected, mirror_tolerance * unit))
        return fault;
    if (exact.decidable && found.total() != exact.total)
        return found.total() ? "total reflection where the ray is refracted"
                             : "refracted where all is reflected";
    const auto share = fresnel<N>(found, from, to);
    if (auto fault = fault_in_reflectance(exact, static_cast<double>(share.perpendicular),
                                          static_cast<double>(share.parallel), scale))
        return fault;
    if (found.total()) return {}; // the mirrored direction was checked above
    const Vec3d direction = as<double>(found.direction);
    if (exact.refracted)
        return fault_in_direction("refracted", direction, *exact.refracted, exact.tolerance * scale);
    if (std::abs(length(direction) - 1) <= grazing_length_tolerance * std::sqrt(unit)) return {};
    return text("refracted direction of length ", hex(length(direction)));
}

} // namespace

void expect_refraction(const std::vector<RefractionCase>& cases, NumbersChoice numbers) {
    constexpr int printed = 5;
    int wrong = 0;
    for (const RefractionCase& exact : cases) {
        const Fault fault = with_numbers(numbers, [&]<Numbers N>() { return fault_in_refraction<N>(exact); });
        if (fault && wrong++ < printed)
            ADD_FAILURE() << *fault << "\n  in " << exact.id << "\n  direction " << hex(exact.direction)
                          << ", normal " << hex(exact.normal) << ", speeds " << hex(exact.speed_from) << ", "
                          << hex(exact.speed_to);
    }
    EXPECT_EQ(wrong, 0) << "cases wrong of " << cases.size();
}

} // namespace rayscope::test
