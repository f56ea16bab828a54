#include "exercises/grader/cut_code.hpp"
#include "exercises/grader/event_case.hpp"

namespace rayscope::exercises {
namespace {

std::string ray_code(const TracedRay& ray) {
    return fmt::format("Ray{{{}, {}}}", code(ray.start().origin), code(ray.start().direction));
}
std::string box_code(const PlaceEntered& place) {
    return fmt::format("Box{{{}, {}}}", code(place.low), code(place.high));
}

/// The event's search, from where it begins to where it ends.
struct Search {
    std::vector<std::string> cells; // with the objects that were hit in each
    std::vector<std::string> hits;
};

Search search_of(const TracedRay& ray) {
    Search search;
    std::vector<std::string> objects;
    const PlaceEntered* cell = nullptr;
    for (const Event& event : ray.events) {
        if (const auto* entered = std::get_if<PlaceEntered>(&event))
            if (entered->kind == PlaceKind::cell) cell = entered, objects.clear();
        if (const auto* hit = std::get_if<ObjectAccepted>(&event)) {
            objects.push_back(std::to_string(search.hits.size()));
            search.hits.push_back(code(hit->t));
        }
        if (std::holds_alternative<PlaceLeft>(event) && cell != nullptr) {
            search.cells.push_back(fmt::format("{{{}, {}, {{{}}}}}", code(cell->t_in), code(cell->t_out),
                                               fmt::join(objects, ", ")));
            cell = nullptr;
        }
    }
    return search;
}

/// Through the cells; without any: all objects in one that has no end.
std::optional<EventCase> first_hit(const TracedRay& ray) {
    Search search = search_of(ray);
    if (search.hits.empty()) return std::nullopt;
    if (search.cells.empty()) {
        std::vector<std::string> all;
        for (std::size_t i = 0; i < search.hits.size(); ++i) all.push_back(std::to_string(i));
        search.cells = {fmt::format("{{0, INF, {{{}}}}}", fmt::join(all, ", "))};
    }
    return EventCase{"6-03-first-hit", list_code("std::vector<Cell>", search.cells) + ", " +
                                           list_code("std::vector<double>", search.hits)};
}

} // namespace

std::optional<EventCase> search_case(const EventPlace& place) {
    const Event& event = place.ray.events[place.index];
    if (const auto* entered = std::get_if<PlaceEntered>(&event)) {
        const auto* began = place.ray.find<SearchBegan>();
        const bool octree = began != nullptr && began->stage == StageKind::octree;
        if (entered->kind == PlaceKind::node && octree)
            return EventCase{"6-02-order", box_code(*entered) + ", " + ray_code(place.ray)};
        if (entered->kind == PlaceKind::extent || entered->kind == PlaceKind::cell ||
            entered->kind == PlaceKind::node)
            return EventCase{"5-01-slab", ray_code(place.ray) + ", " + box_code(*entered)};
    }
    // A shadow ray asks whether anything is in its way, not for the nearest.
    const bool nearest = place.ray.start().kind != RayKind::shadow;
    if (nearest &&
        (std::holds_alternative<BoundaryChosen>(event) || std::holds_alternative<ObjectAccepted>(event) ||
         std::holds_alternative<SearchEnded>(event)))
        return first_hit(place.ray);
    return std::nullopt;
}

} // namespace rayscope::exercises
