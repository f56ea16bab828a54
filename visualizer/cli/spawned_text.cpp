// What a ray spawned, what it did not, and why.

#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {
namespace {

int child_of_kind(const Trace& trace, int ray, RayKind kind, double wavelength) {
    for (const int child : trace.rays[std::size_t(ray)].children) {
        const RaySpawned& start = trace.rays[std::size_t(child)].start();
        if (start.kind == kind && (kind == RayKind::reflected || start.wavelength == wavelength))
            return child;
    }
    return none;
}

void add_child(Page& page, const Trace& trace, int ray, RayKind kind, const Colour& coefficient,
               const StepStyle& style, double wavelength = 0) {
    const int child = child_of_kind(trace, ray, kind, wavelength);
    if (child == none) return; // refused: its reason follows, or the record was full
    const Numbers& number = style.number;
    const Colour& own = trace.rays[std::size_t(ray)].start().weight;
    page.item("spawns", style.paint.kind(kind, "ray " + std::to_string(child)) + ", weight " +
                            number.colour(own) + " × " + number.colour(coefficient) + " = " +
                            number.colour(trace.rays[std::size_t(child)].start().weight));
}

std::string critical_text(const BoundaryChosen& hit, double theta, double critical, const Numbers& number) {
    if (std::isnan(critical))
        return hit.speed_from == hit.speed_to ? "none: both media have the same speed, and nothing is bent"
                                              : "none: light is slower behind the surface";
    const double distance = (theta - critical);
    return "arcsin(c₁/c₂) = " + number.degrees(critical) + "; θ₁ is " + number.degrees(std::abs(distance)) +
           (distance > 0 ? " above it" : " below it");
}

void add_reflected(Page& page, const Trace& trace, int ray, const Reflected& reflected,
                   const StepStyle& style) {
    const Numbers& number = style.number;
    page.heading("Reflection: d − 2(d·n)n");
    page.item("coefficient", number.colour(reflected.coefficient));
    page.item("angle", "θ = " + number.degrees(reflected.theta) + " on both sides of the normal");
    page.item("direction", number.vector(reflected.direction));
    add_child(page, trace, ray, RayKind::reflected, reflected.coefficient, style);
}

void add_eta(Page& page, const BoundaryChosen& hit, double eta, double wavelength, const Numbers& number) {
    if (wavelength > 0)
        page.item("speeds", "eta = c₂/c₁ = " + number(eta) + " at this wavelength");
    else
        page.item("speeds", "c₁ = " + number(hit.speed_from) + ", c₂ = " + number(hit.speed_to) +
                                ", eta = c₂/c₁ = " + number(eta));
}

std::string of_wavelength(double wavelength, const Numbers& number) {
    return wavelength > 0 ? ", " + number(wavelength) + " nm" : "";
}

void add_fresnel(Page& page, const FresnelShared& shared, const StepStyle& style) {
    const Numbers& number = style.number;
    page.heading("Fresnel: how much is reflected" + of_wavelength(shared.wavelength, number));
    page.item("R", "(Rs + Rp) / 2 = (" + number(shared.perpendicular) + " + " + number(shared.parallel) +
                       ") / 2 = " + number((shared.perpendicular + shared.parallel) / 2));
    page.item("Schlick", number(shared.schlick) + ", his approximation");
    page.item("reflected",
              number(shared.reflected) + "; the rest, " + number(1 - shared.reflected) + ", goes through");
}

void add_refracted(Page& page, const Trace& trace, int ray, const BoundaryChosen& hit,
                   const Refracted& refracted, const StepStyle& style) {
    const Numbers& number = style.number;
    page.heading("Refraction: sin θ₂ = (c₂/c₁) sin θ₁" + of_wavelength(refracted.wavelength, number));
    page.item("coefficient", number.colour(refracted.coefficient));
    add_eta(page, hit, refracted.eta, refracted.wavelength, number);
    page.item("angles", "θ₁ = " + number.degrees(refracted.theta_from) +
                            ", θ₂ = " + number.degrees(refracted.theta_to));
    page.item("Snell", "sin θ₂ = " + number(refracted.eta) + " × " + number(std::sin(refracted.theta_from)) +
                           " = " + number(std::sin(refracted.theta_to)));
    page.item("critical", critical_text(hit, refracted.theta_from, refracted.critical, number));
    page.item("direction", number.vector(refracted.direction));
    add_child(page, trace, ray, RayKind::refracted, refracted.coefficient, style, refracted.wavelength);
}

void add_total(Page& page, const BoundaryChosen& hit, const TotallyReflected& total, const StepStyle& style) {
    const Numbers& number = style.number;
    page.heading("Total internal reflection: no θ₂ exists" + of_wavelength(total.wavelength, number));
    add_eta(page, hit, total.eta, total.wavelength, number);
    page.item("Snell", "θ₁ = " + number.degrees(total.theta_from) + "; sin θ₂ would be " + number(total.eta) +
                           " × " + number(std::sin(total.theta_from)) + " = " +
                           number(total.eta * std::sin(total.theta_from)) + ", more than 1");
    page.item("critical", critical_text(hit, total.theta_from, total.critical, number));
    page.item("coefficient",
              number.colour(total.coefficient) + ": one mirrored ray carries reflection + transmission");
}

std::string refusal_text(const Trace& trace, const TracedRay& ray, const NotSpawned& refused,
                         const Numbers& number) {
    const std::string would = "it would have carried the weight " + number.colour(refused.weight);
    switch (refused.reason) {
    case Reason::coefficient_zero:
        return refused.kind == RayKind::refracted
                   ? "the material lets no light through: its transmission is 0"
                   : "the material mirrors nothing: its reflection is 0";
    case Reason::depth:
        return "this ray's depth " + std::to_string(ray.start().depth) + " has reached max_depth " +
               std::to_string(trace.max_depth) + "; " + would + ", which is lost";
    case Reason::weight:
        return would + ", less than min_weight " + number(trace.min_weight) + ", and is left out";
    case Reason::ray_limit: return "the sample has spent the scene's max_rays; " + would;
    case Reason::total_internal_reflection:
    case Reason::leaves_solid: break; // neither keeps back a ray that is listed
    }
    return "";
}

} // namespace

void add_spawned(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const auto* hit = ray.find<BoundaryChosen>();
    if (hit == nullptr) return;
    bool refusals = false;
    for (const Event& event : ray.events) {
        if (const auto* shared = std::get_if<FresnelShared>(&event)) add_fresnel(page, *shared, style);
        if (const auto* total = std::get_if<TotallyReflected>(&event)) add_total(page, *hit, *total, style);
        if (const auto* reflected = std::get_if<Reflected>(&event))
            add_reflected(page, trace, index, *reflected, style);
        if (const auto* refracted = std::get_if<Refracted>(&event))
            add_refracted(page, trace, index, *hit, *refracted, style);
    }
    for (const Event& event : ray.events) {
        const auto* refused = std::get_if<NotSpawned>(&event);
        // That of a total reflection is told with the reflection.
        if (refused == nullptr || refused->reason == Reason::total_internal_reflection) continue;
        if (!refusals) page.heading("Not followed");
        refusals = true;
        page.item(name_of(refused->kind), refusal_text(trace, ray, *refused, style.number));
    }
}

} // namespace rayscope::cli
