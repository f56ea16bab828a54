#include "core/walk/refraction_card.hpp"

#include "core/refraction/fresnel.hpp"

namespace rayscope {
namespace {

/// R₀ + (1 − R₀)(1 − cos θ)⁵, with θ on the side of the slower light, where it is larger; 1 at total reflection.
double schlick(double speed_from, double speed_to, double theta_from, const std::optional<double>& theta_to) {
    if (!theta_to) return 1;
    const double r = (speed_from - speed_to) / (speed_from + speed_to), least = r * r;
    const double rest = 1 - std::cos(speed_from < speed_to ? *theta_to : theta_from);
    return least + (1 - least) * rest * rest * rest * rest * rest;
}

} // namespace

std::optional<RefractionCard> refraction_card(const Trace& trace, int index) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const auto* hit = ray.find<BoundaryChosen>();
    const auto* bent = ray.find<Refracted>();
    const auto* total = ray.find<TotallyReflected>();
    if (hit == nullptr || (bent == nullptr && total == nullptr)) return std::nullopt;
    RefractionCard card;
    card.medium_from = hit->medium_from;
    card.medium_to = hit->medium_to;
    card.speed_from = hit->speed_from;
    card.speed_to = hit->speed_to;
    card.eta = bent != nullptr ? bent->eta : total->eta;
    card.theta_from = bent != nullptr ? bent->theta_from : total->theta_from;
    if (bent != nullptr) card.theta_to = bent->theta_to;
    card.critical = critical_angle(card.speed_from, card.speed_to);
    if (bent != nullptr) {
        const Refraction<double> refraction =
            refract<double>(ray.start().direction, hit->facing, card.speed_from, card.speed_to);
        const Reflectance<double> reflected = fresnel<double>(refraction, card.speed_from, card.speed_to);
        card.fresnel = reflected.unpolarized();
        card.fresnel_s = reflected.perpendicular;
        card.fresnel_p = reflected.parallel;
        card.transmission = bent->coefficient;
    }
    card.schlick = schlick(card.speed_from, card.speed_to, card.theta_from, card.theta_to);
    if (const auto* mirrored = ray.find<Reflected>()) card.reflection = mirrored->coefficient;
    return card;
}

} // namespace rayscope
