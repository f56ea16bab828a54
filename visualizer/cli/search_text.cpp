// How a stage looked for the hit: the places that it came to, and what they saved.

#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

#include <vector>

namespace rayscope::cli {
namespace {

constexpr std::size_t most_places = 24; // a person reads no more

/// A place, and what was done in it as far as its end was recorded.
struct Visit {
    PlaceEntered place;
    const PlaceLeft* left = nullptr;
};

// Nothing lies in a place that holds objects but entries of its list and parts of its compounds, which are places, too.
std::vector<Visit> visits_of(const TracedRay& ray) {
    std::vector<Visit> visits;
    std::size_t open = 0;
    for (const Event& event : ray.events) {
        if (const auto* place = std::get_if<PlaceEntered>(&event)) {
            visits.push_back({*place});
            if (place->kind != PlaceKind::entry && place->kind != PlaceKind::part) open = visits.size() - 1;
        } else if (const auto* left = std::get_if<PlaceLeft>(&event);
                   left != nullptr && open < visits.size()) {
            visits[open].left = left;
        }
    }
    return visits;
}

std::string stretch(const PlaceEntered& place, const Numbers& number) {
    return "t" + std::string(glue) + number(place.t_in) + glue + "…" + glue + number(place.t_out);
}

std::string whole(double pixel) { return std::to_string(int(pixel)); }

std::string place_text(const Trace& trace, const PlaceEntered& place, const Numbers& number) {
    const std::string name = std::to_string(place.place), level = ", level " + std::to_string(place.level);
    switch (place.kind) {
    case PlaceKind::extent:
        return "box of " + object_name(trace, place.object) + ": " + stretch(place, number);
    case PlaceKind::tile:
        return "tile " + name + " of the screen: pixels (" + whole(place.low.x) + "," + glue +
               whole(place.low.y) + ") to (" + whole(place.high.x) + "," + glue + whole(place.high.y) + ")";
    case PlaceKind::light_cell:
        return "cell (" + whole(place.low.x) + "," + glue + whole(place.low.y) +
               ") of what the light sees, from it " + number(place.t_out) + " away";
    case PlaceKind::entry:
        return "  " + object_name(trace, place.object) + ", nowhere nearer than " + number(place.t_in);
    case PlaceKind::cell: return "cell " + name + level + ": " + stretch(place, number);
    case PlaceKind::node: return "node " + name + level + ": " + stretch(place, number);
    case PlaceKind::part:
        return "  part " + name + " of " + object_name(trace, place.object) + ", " +
               counted(place.held, "generic", "generics") + ": " + stretch(place, number);
    }
    return name;
}

std::string done_there(const Visit& visit) {
    if (visit.place.kind == PlaceKind::node) return "; " + counted(visit.place.held, "child", "children");
    if (visit.place.object != none) return ""; // what it holds was told
    std::string text = "; holds " + std::to_string(visit.place.held);
    if (visit.left == nullptr) return text;
    text += ": " + counted(visit.left->tested, "test", "tests");
    if (visit.left->spared > 0) text += ", " + std::to_string(visit.left->spared) + " spared";
    return text;
}

std::string why_it_ended(const SearchEnded& end, RayKind kind, const Numbers& number) {
    switch (end.reason) {
    case SearchEnd::nothing_left: return "no place is left on the ray's way";
    case SearchEnd::beyond_reach:
        return std::string("all places left begin beyond ") +
               (kind == RayKind::shadow ? "the light, t = " : "the nearest hit, t = ") + number(end.t);
    case SearchEnd::blocked: return "something opaque stands in the way";
    case SearchEnd::covered: return "an opaque object nearer to the light covers the whole cell";
    }
    return "";
}

std::string summary(const SearchBegan& began, const SearchEnded& end) {
    std::string text = std::string(name_of(began.stage)) + ": ";
    if (end.missed > 0) text += counted(end.missed, "box missed", "boxes missed") + ", ";
    if (end.places > 0) {
        const bool lists = began.stage == StageKind::projective || began.stage == StageKind::light;
        text += counted(end.places, lists ? "list" : "cell", lists ? "lists" : "cells") + ", ";
    }
    return text + counted(end.tested, "test", "tests") + ", " + std::to_string(end.spared) + " saved of " +
           counted(began.objects, "object", "objects");
}

} // namespace

void add_search(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const auto* began = ray.find<SearchBegan>();
    const auto* ended = ray.find<SearchEnded>();
    if (began == nullptr) return;
    page.heading("Search: where the stage looked for crossings");
    const auto visits = visits_of(ray);
    for (std::size_t i = 0; i < std::min(visits.size(), most_places); ++i)
        page.line(place_text(trace, visits[i].place, style.number) + done_there(visits[i]), 2);
    if (visits.size() > most_places)
        page.line("… and " + std::to_string(visits.size() - most_places) + " more places", 2);
    if (ended == nullptr) return;
    page.line("It ends: " + why_it_ended(*ended, ray.start().kind, style.number) + ".", 2);
    page.line(style.paint.bold(summary(*began, *ended)), 2);
}

} // namespace rayscope::cli
