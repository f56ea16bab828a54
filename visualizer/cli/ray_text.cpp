// One ray: its parts in the order in which they happened.

#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {
namespace {

std::string medium_text(const Trace& trace, Id medium, const Numbers& number) {
    if (medium == none) return "unknown";
    return medium_name(trace, medium) + ", where light has the speed " +
           number(trace.media[std::size_t(medium)].speed);
}

std::string shadow_answer(const RayFinished& end, const Numbers& number) {
    if (end.colour == Colour{0})
        return "something opaque, or nothing but dark glass, is in the way: visibility 0";
    if (end.colour == Colour{1}) return "nothing is in the way: visibility 1";
    return "visibility " + number.colour(end.colour);
}

void add_absorbed(Page& page, const Trace& trace, const TracedRay& ray, const Numbers& number) {
    for (const Event& event : ray.events)
        if (const auto* absorbed = std::get_if<Absorbed>(&event))
            page.item("absorbed", "exp(−absorption × " + number(absorbed->length) + ") in " +
                                      medium_name(trace, absorbed->medium) + " leaves " +
                                      number.colour(absorbed->passed));
}

/// Of the parts of a ray only its end is kept after that.
void add_truncation(Page& page, const TracedRay& ray) {
    if (ray.find<Truncated>() == nullptr) return;
    page.gap();
    page.line(
        "Here the record was full: nothing more is kept, but the ends of the rays that were under way.");
}

void add_shadow_answer(Page& page, const Trace& trace, const TracedRay& ray, const StepStyle& style) {
    add_truncation(page, ray);
    page.heading("Is the light seen?");
    for (const Event& event : ray.events)
        if (const auto* passed = std::get_if<BlockerPassed>(&event))
            page.item("× " + style.number.colour(passed->transmission),
                      "transmission of " + object_name(trace, passed->object) +
                          ", a boundary at t = " + style.number(passed->t));
    add_absorbed(page, trace, ray, style.number);
    if (const auto* end = ray.find<RayFinished>()) page.line(shadow_answer(*end, style.number), 2);
}

} // namespace

void add_start(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const RaySpawned& start = ray.start();
    const Numbers& number = style.number;
    page.rule(style.paint.kind(start.kind, "ray " + std::to_string(index) + ", " + name_of(start.kind)));
    if (ray.parent != none) page.item("spawned by", ray_name(ray.parent));
    if (start.kind == RayKind::shadow)
        page.item("asks for", "light " + light_name(trace, start.light));
    else
        page.item("depth", std::to_string(start.depth) + " of at most " + std::to_string(trace.max_depth) +
                               "; weight " + number.colour(start.weight) + ", its share of the pixel");
    page.item("origin", number.vector(start.origin));
    page.item("direction", number.vector(start.direction));
    if (const double given = trace.source.given_length; index == 0 && trace.source.by_hand && given != 1)
        page.item("", "|d| = " + number(given) + ": t counts lengths of d; shading takes d / |d|");
    if (start.kind == RayKind::shadow)
        page.item("reach", std::isinf(start.reach)
                               ? "∞: the light is infinitely far away"
                               : "t = " + number(start.reach) + ", the distance of the light");
    page.item("medium", medium_text(trace, start.medium, number));
    if (start.wavelength > 0)
        page.item("wavelength", number(start.wavelength) + " nm: the part of the spectrum that it carries");
    if (start.left_object != none)
        page.item("starts on", object_name(trace, start.left_object) + ", whose surface is ignored within " +
                                   number(start.left_bound) + " of the origin");
}

void add_hit(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const Numbers& number = style.number;
    if (const auto* missed = ray.find<Missed>()) {
        page.heading("Nothing is hit");
        page.item("background", number.colour(missed->background));
        add_absorbed(page, trace, ray, number);
        return;
    }
    const auto* hit = ray.find<BoundaryChosen>();
    if (hit == nullptr) return;
    const std::string object = object_name(trace, hit->object);
    const std::string leaf = generic_name_of(trace, hit->boundary.leaf);
    page.heading("Hit: the nearest crossing");
    page.item("object", object + (leaf == object ? "" : ", through the surface of " + leaf) +
                            (hit->boundary.flipped ? ", which is subtracted: its normal is turned" : "") +
                            (hit->entering ? "; the ray enters" : "; the ray leaves"));
    page.item("t", number(hit->boundary.t) + " ± " + number(hit->error_bound));
    page.item("point", "origin + t · direction = " + number.vector(hit->point));
    if (const auto* triangle = ray.find<TriangleHit>()) {
        const auto part = [&](double share, int vertex) {
            return number(share) + " of vertex " + std::to_string(vertex);
        };
        page.item("triangle", std::to_string(triangle->triangle) +
                                  " of the mesh: " + part(triangle->shares.x, triangle->corner_a) + ", " +
                                  part(triangle->shares.y, triangle->corner_b) + ", " +
                                  part(triangle->shares.z, triangle->corner_c));
    }
    page.item("normal", "n = " + number.vector(hit->normal) + ", outward");
    if (hit->facing != hit->normal)
        page.item("", "turned against the ray: n = " + number.vector(hit->facing));
    add_absorbed(page, trace, ray, number);
    if (hit->medium_from == hit->medium_to) return; // an opaque object: nothing goes on
    page.item("media", "from " + medium_name(trace, hit->medium_from) + " (speed" + glue +
                           number(hit->speed_from) + ") to " + medium_name(trace, hit->medium_to) +
                           " (speed" + glue + number(hit->speed_to) + ")");
}

std::string ray_text(const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    Page page(style.paint);
    add_start(page, trace, index, style);
    add_search(page, trace, index, style);
    add_spans(page, trace, index, style);
    if (ray.start().kind == RayKind::shadow) {
        add_shadow_answer(page, trace, ray, style);
    } else {
        add_hit(page, trace, index, style);
        add_light(page, trace, index, style);
        add_spawned(page, trace, index, style);
        add_truncation(page, ray);
        add_sum(page, trace, index, style);
    }
    if (ray.find<RayFinished>() == nullptr)
        page.line("The record was full: the rest of this ray is missing.");
    return page.text();
}

} // namespace rayscope::cli
