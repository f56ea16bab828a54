#pragma once
// All numbers of one boundary that lets light through, side by side.

#include "core/trace/trace.hpp"

namespace rayscope {

struct RefractionCard {
    Id medium_from = none, medium_to = none; ///< index into Trace::media
    double speed_from = 1, speed_to = 1;
    double eta = 1;                      ///< speed_to / speed_from
    double theta_from = 0;               ///< radians
    std::optional<double> theta_to;      ///< none: total internal reflection
    std::optional<double> critical;      ///< none: light is not faster behind the boundary
    double fresnel = 1;                  ///< reflected share by Fresnel's equations, unpolarized
    double fresnel_s = 1, fresnel_p = 1; ///< … of the two polarizations
    double schlick = 1;                  ///< Schlick's approximation (1994) of the first
    Colour reflection{0},
        transmission{0}; ///< what the rays carry; all of it the mirrored one at total reflection
    [[nodiscard]] bool total() const { return !theta_to; }
    /// θ₁ − critical angle, radians.
    [[nodiscard]] std::optional<double> beyond_critical() const {
        return critical ? std::optional(theta_from - *critical) : std::nullopt;
    }
};

/// Of the hit of a ray; nothing where no bent ray was considered.
[[nodiscard]] std::optional<RefractionCard> refraction_card(const Trace& trace, int ray);

} // namespace rayscope
