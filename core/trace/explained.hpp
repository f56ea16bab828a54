#pragma once
// How far the numbers of two runs may differ without either being wrong. Each bound is of first order in the differences
// that a step begins with; where a root or a quotient could double that, it is doubled.

#include "core/trace/divergence.hpp"

namespace rayscope {

/// Differences between the starts of a ray in two runs, and at its hit.
struct Drift {
    Vec3d origin{0}, direction{0}; ///< absolute, of each component
    double turn = 0;               ///< of the direction: |Δd| / |d|, about an angle
    double normal = 0;             ///< |Δn|
    double point = 0;              ///< |Δp|, of the hit
};

[[nodiscard]] Drift drift_of(const RaySpawned& first, const RaySpawned& second);

/// The bounds of both runs on the t of their hits; one that has none is granted the other's, in proportion to ε (which is
/// generous where a ray grazes: there the true bound grows with √ε).
[[nodiscard]] double bounds_of_t(const BoundaryChosen& first, const BoundaryChosen& second,
                                 double epsilon_first, double epsilon_second);

/// Of t: a surface met with slope s = n·d, whose ray starts Δo and Δd apart, is met at most 2 (|n|·Δo + |t| |n|·Δd) / |s|
/// apart (the 2 is for the square root where it grazes: see root_shift), and each run adds its own bound.
[[nodiscard]] double explained_t(const BoundaryChosen& hit, const RaySpawned& start, const Drift& drift,
                                 double bounds);

/// Of d − 2 (d·n) n.
[[nodiscard]] double explained_mirrored(const Drift& drift, double epsilon);

/// Of the bent direction η (d + cos θ₁ n) − cos θ₂ n: θ₂ moves by η cos θ₁ / cos θ₂ times as much as θ₁.
[[nodiscard]] double explained_bent(const Refracted& bent, const Drift& drift, double epsilon);

/// Of the share of the light that Fresnel's equations, or Schlick's approximation, mirror: its derivatives by cos θ₁ and
/// cos θ₂ are at most 5 / cos θ₁ and 5 / cos θ₂, and θ₂ moves as above. Where nothing goes on to tell of θ₂: as near the
/// critical angle, by the root of what the angle moves.
[[nodiscard]] double explained_share(const TracedRay& ray, const Drift& drift, double epsilon);

/// Of the product of all factors that a ray's light is multiplied with on its way to here: the factors' own differences.
/// One by more than √ε is not what precision brings about.
[[nodiscard]] double explained_factors(const TracedRay& a, const TracedRay& b, double epsilon);

/// Of the direction to a light at this distance.
[[nodiscard]] double explained_to_light(const TraceLight& light, const Vec3d& point, const Drift& drift,
                                        double epsilon);

/// The difference in ulps of numbers of this size: a component of a vector is measured by the largest.
[[nodiscard]] double in_ulps(double difference, double size, const Precision& precision);

} // namespace rayscope
