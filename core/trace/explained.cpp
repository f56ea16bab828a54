#include "core/trace/explained.hpp"

#include "core/trace/events_of.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

/// The factor that an event is, if it is one.
std::optional<Colour> factor_of(const Event& event) {
    if (const auto* absorbed = std::get_if<Absorbed>(&event)) return absorbed->passed;
    if (const auto* passed = std::get_if<BlockerPassed>(&event)) return passed->transmission;
    if (const auto* mirrored = std::get_if<Reflected>(&event)) return mirrored->coefficient;
    if (const auto* bent = std::get_if<Refracted>(&event)) return bent->coefficient;
    return std::nullopt;
}

std::vector<Colour> factors_of(const TracedRay& ray) {
    std::vector<Colour> factors;
    for (const Event& event : ray.events)
        if (const auto factor = factor_of(event)) factors.push_back(*factor);
    return factors;
}

} // namespace

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

double explained_share(const TracedRay& ray, const Drift& drift, double epsilon) {
    const double before = drift.turn + drift.normal + 8 * epsilon;
    const auto bent = events_of<Refracted>(ray);
    if (bent.empty()) return 2 * std::sqrt(before);
    double sum = 0;
    for (const Refracted* one : bent) {
        const double from = std::cos(one->theta_from), to = std::cos(one->theta_to);
        sum += 5 * before * (1 / from + one->eta * one->eta * from / (to * to));
    }
    return sum;
}

double explained_factors(const TracedRay& a, const TracedRay& b, double epsilon) {
    const auto in_a = factors_of(a), in_b = factors_of(b);
    double sum = 0;
    for (std::size_t i = 0; i < std::min(in_a.size(), in_b.size()); ++i) {
        const double difference = largest_component(absolute(in_a[i] - in_b[i]));
        if (difference <= std::sqrt(epsilon)) sum += difference;
    }
    return sum;
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
