#pragma once
// When the recursion ends.

#include "core/trace/events.hpp"

#include <optional>

namespace rayscope {

/// Where a ray stands in the recursion.
struct Budget {
    int depth = 0;
    Colour weight{1}; ///< share of the pixel, per colour: the product of the coefficients on the way
    Id medium =
        none; ///< that it travels in: for absorption and the record; shading reads the media at each boundary
    float wavelength = 0;   ///< nm; 0: all of them
    std::uint32_t path = 0; ///< what is random about this ray is hashed from it

    [[nodiscard]] Budget after(const Colour& coefficient, Id next_medium = none) const {
        return {depth + 1, weight * coefficient, next_medium, wavelength, path};
    }
};

/// Both limits are needed: a weight never ends perfect mirrors, a depth alone follows rays that nobody would see.
/// The sample's number of rays is a last guard.
struct RecursionLimits {
    int max_depth;
    double min_weight;

    /// Why a ray is not spawned, or nothing: it is, if depth < max_depth and its own weight is > 0 and ≥ min_weight.
    [[nodiscard]] std::optional<Reason> refusal(const Budget& parent, const Colour& coefficient,
                                                int rays_left) const {
        if (!(largest_component(coefficient) > 0)) return Reason::coefficient_zero;
        if (parent.depth >= max_depth) return Reason::depth;
        const double weight = largest_component(parent.after(coefficient).weight);
        if (!(weight > 0) || weight < min_weight) return Reason::weight;
        if (rays_left == 0) return Reason::ray_limit;
        return std::nullopt;
    }
};

} // namespace rayscope
