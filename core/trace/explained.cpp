#include "core/trace/explained.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {

Drift drift_of(const RaySpawned& first, const RaySpawned& second) {
    Drift drift;
    drift.origin = absolute(first.origin - second.origin);
    drift.direction = absolute(first.direction - second.direction);
    drift.turn = length(drift.direction) / length(first.direction);
    return drift;
}

double bounds_of_t(const BoundaryChosen& first, const BoundaryChosen& second, double epsilon_first,
                   double epsilon_second) {
    const double a = first.error_bound, b = second.error_bound;
    const double of_first = a > 0 ? a : b * epsilon_first / epsilon_second;
    const double of_second = b > 0 ? b : a * epsilon_second / epsilon_first;
    return of_first + of_second;
}

double explained_t(const BoundaryChosen& hit, const RaySpawned& start, const Drift& drift, double bounds) {
    const Vec3d n = absolute(hit.normal);
    const double moved = dot(n, drift.origin) + std::abs(hit.boundary.t) * dot(n, drift.direction);
    return moved > 0 ? bounds + 2 * moved / std::abs(dot(hit.normal, start.direction)) : bounds;
}

double explained_mirrored(const Drift& drift, double epsilon) {
    return 3 * drift.turn + 4 * drift.normal + 8 * epsilon;
}

double explained_bent(const Refracted& bent, const Drift& drift, double epsilon) {
    const double before = drift.turn + drift.normal + 8 * epsilon;
    const double cosine = std::cos(bent.theta_to);
    return 2 * before * (1 + bent.eta + bent.eta * std::cos(bent.theta_from) / cosine);
}

double explained_to_light(const TraceLight& light, const Vec3d& point, const Drift& drift, double epsilon) {
    if (light.directional) return 4 * epsilon;
    const double rounded = epsilon * (length(light.position) + length(point));
    return 2 * (drift.point + rounded) / length(light.position - point) + 4 * epsilon;
}

double in_ulps(double difference, double size, const Precision& precision) {
    if (difference == 0) return 0;
    if (!std::isfinite(difference)) return infinity<double>;
    return difference / std::ldexp(precision.epsilon, std::ilogb(std::max(std::abs(size), precision.least)));
}

} // namespace rayscope
