#include "exercises/grader/cut_code.hpp"
#include "exercises/grader/event_case.hpp"

namespace rayscope::exercises {
namespace {

/// The boundary on which the event happened: itself, or the last one before it.
const BoundaryChosen* boundary_at(const EventPlace& place) {
    const BoundaryChosen* last = nullptr;
    for (std::size_t i = 0; i <= place.index; ++i)
        if (const auto* chosen = std::get_if<BoundaryChosen>(&place.ray.events[i])) last = chosen;
    return last;
}

struct SurfaceCases {
    const BoundaryChosen& at;
    Vec3d d; // unit

    std::optional<EventCase> operator()(const Reflected&) const {
        return EventCase{"3-01-mirror", fmt::format("{}, {}, {}", code(at.point), code(d), code(at.facing))};
    }
    // eta is the ratio of the speeds of its wavelength.
    std::optional<EventCase> operator()(const Refracted& bent) const { return refracted(bent.eta); }
    std::optional<EventCase> operator()(const TotallyReflected& total) const { return refracted(total.eta); }
    std::optional<EventCase> operator()(const FresnelShared&) const {
        return EventCase{"8-02-fresnel", fmt::format("{}, {}, {}", code(at.speed_from), code(at.speed_to),
                                                     code(std::abs(dot(d, at.facing))))};
    }
    std::optional<EventCase> operator()(const BoundaryChosen&) const { return wall(); }
    std::optional<EventCase> operator()(const LocalLightSkipped&) const { return wall(); }
    template <typename Other> std::optional<EventCase> operator()(const Other&) const { return std::nullopt; }

private:
    [[nodiscard]] std::optional<EventCase> refracted(double eta) const {
        return EventCase{"4-02-refract", fmt::format("{}, {}, {}, {}", code(d), code(at.facing),
                                                     code(at.speed_from), code(eta * at.speed_from))};
    }
    /// Of a transparent object that stands in air.
    [[nodiscard]] std::optional<EventCase> wall() const {
        const double outside = at.entering ? at.speed_from : at.speed_to,
                     inside = at.entering ? at.speed_to : at.speed_from;
        if (at.medium_from == none || at.medium_to == none || outside != 1 || inside == 1)
            return std::nullopt;
        return EventCase{"4-03-wall", fmt::format("{}, {}, {}", code(d), code(at.normal), code(inside))};
    }
};

} // namespace

std::optional<EventCase> surface_case(const EventPlace& place) {
    const BoundaryChosen* const at = boundary_at(place);
    if (at == nullptr) return std::nullopt;
    return std::visit(SurfaceCases{*at, normalized(place.ray.start().direction)},
                      place.ray.events[place.index]);
}

} // namespace rayscope::exercises
