// Local light, term by term, with the numbers multiplied out.

#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

#include <vector>

namespace rayscope::cli {
namespace {

std::string times(const std::string& factor) { return " ×" + std::string(glue) + factor; }
std::string equals(const std::string& value) { return " =" + std::string(glue) + value; }

std::string visibility_text(const Trace& trace, int ray, const LightLit& lit, const Numbers& number) {
    const int shadow = shadow_ray_of(trace, trace.rays[std::size_t(ray)], lit);
    const std::string seen = "visibility " + number.colour(lit.visibility) + ", ";
    if (shadow != none) return seen + "by shadow " + ray_name(shadow);
    return seen + (lit.cosine > 0 ? "no shadow ray was needed" : "not asked for");
}

void add_term(Page& page, const std::string& label, std::vector<std::string> factors, const Colour& term,
              const Numbers& number) {
    std::string text = factors.front();
    for (std::size_t i = 1; i < factors.size(); ++i) text += times(factors[i]);
    page.item(label, text + equals(number.colour(term)), 1);
}

void add_one_light(Page& page, const Trace& trace, int ray, const LightLit& lit, const StepStyle& style) {
    const Numbers& number = style.number;
    const TraceLight& light = trace.lights[std::size_t(lit.light)];
    page.item("light " + light_name(trace, lit.light),
              (light.directional ? "directional, " : "at " + number.vector(light.position) + ", ") +
                  "intensity " + number.colour(lit.intensity));
    page.item("", "l = " + number.vector(lit.to_light) + ", towards it");
    if (!(lit.cosine > 0)) {
        page.item("", "n·l = " + number(lit.cosine) + ": it is behind the surface and adds nothing");
        return;
    }
    page.item("", "n·l" + equals(number(lit.cosine)) + "; r·v" + equals(number(lit.mirror_cosine)) +
                      " (r: l mirrored at n, v: back along the ray)");
    page.item("", visibility_text(trace, ray, lit, number));
    const std::string intensity = number.colour(lit.intensity), seen = number.colour(lit.visibility);
    const bool black = lit.diffuse_coefficient == Colour{0};
    if (black)
        page.item("diffuse", "0: the coefficient is 0", 1);
    else
        add_term(page, "diffuse",
                 {number.colour(lit.diffuse_coefficient), number(lit.cosine), intensity, seen}, lit.diffuse,
                 number);
    if (lit.specular_coefficient == Colour{0}) {
        page.item("specular", "0: the coefficient is 0", 1);
    } else if (!(lit.mirror_cosine > 0)) {
        page.item("specular", "0: r·v is not positive, r points away from the viewer", 1);
    } else {
        const double share = specular_share(lit.cosine, lit.mirror_cosine, lit.shininess);
        page.item("", "(r·v)^shininess" + equals(number(lit.mirror_cosine) + "^" + number(lit.shininess)) +
                          equals(number(share)));
        add_term(page, "specular", {number.colour(lit.specular_coefficient), number(share), intensity, seen},
                 lit.specular, number);
    }
}

bool leads_to_its_middle(const Trace& trace, const TracedRay& ray, const LightLit& lit) {
    constexpr double rounding = 1e-12;
    const TraceLight& light = trace.lights[std::size_t(lit.light)];
    if (light.directional) return true;
    return length(lit.to_light - normalized(light.position - ray.find<BoundaryChosen>()->point)) < rounding;
}

/// A point of a light's area: its sums alone.
void add_point(Page& page, const Trace& trace, int ray, const LightLit& lit, const StepStyle& style) {
    const Numbers& number = style.number;
    if (lit.sample == 0)
        page.item("light " + light_name(trace, lit.light),
                  "has an area: " + counted(lit.samples, "point", "points") + ", each of intensity " +
                      number.colour(lit.intensity));
    const std::string label = "point " + std::to_string(lit.sample + 1);
    if (!(lit.cosine > 0))
        page.item(label, "behind the surface", 1);
    else
        page.item(label,
                  "n·l" + equals(number(lit.cosine)) + ", " + visibility_text(trace, ray, lit, number) +
                      ": " + number.colour(lit.diffuse) + " diffuse, " + number.colour(lit.specular) +
                      " specular",
                  1);
}

/// Lights that add something to the local sum, whose terms are listed in it.
std::string sum_of_terms(const TracedRay& ray, const Numbers& number) {
    std::string text;
    const auto add = [&](const Colour& term) {
        if (term != Colour{0}) text += (text.empty() ? "" : " +" + std::string(glue)) + number.colour(term);
    };
    for (const Event& event : ray.events) {
        if (const auto* ambient = std::get_if<AmbientLit>(&event)) add(ambient->scene * ambient->material);
        if (const auto* lit = std::get_if<LightLit>(&event)) {
            add(lit->diffuse);
            add(lit->specular);
        }
    }
    return text;
}

} // namespace

void add_light(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const Numbers& number = style.number;
    if (ray.find<BoundaryChosen>() == nullptr) return;
    page.heading("Local light");
    if (ray.find<LocalLightSkipped>() != nullptr) {
        page.line(
            "None: the ray leaves a solid that lets light through, and its surface is lit from outside only.",
            2);
        return;
    }
    page.line(style.paint.dim("diffuse = coefficient × n·l × light × visibility"), 2);
    page.line(style.paint.dim("specular = coefficient × (r·v)^shininess × light × visibility"), 2);
    for (const Event& event : ray.events) {
        if (const auto* ambient = std::get_if<AmbientLit>(&event))
            page.item("ambient",
                      "scene " + number.colour(ambient->scene) +
                          times("material" + std::string(glue) + number.colour(ambient->material)) +
                          equals(number.colour(ambient->scene * ambient->material)));
        if (const auto* lit = std::get_if<LightLit>(&event)) {
            if (lit->samples > 1 || !leads_to_its_middle(trace, ray, *lit))
                add_point(page, trace, index, *lit, style);
            else
                add_one_light(page, trace, index, *lit, style);
        }
    }
    if (const auto* end = ray.find<RayFinished>()) {
        const std::string terms = sum_of_terms(ray, number);
        page.item("local sum", terms.empty() ? "0" : terms + equals(number.colour(end->local)));
    }
}

} // namespace rayscope::cli
