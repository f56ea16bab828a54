#include "visualizer/window/octree_facts.hpp"

#include <algorithm>
#include <map>

namespace rayscope::window {

int OctreeFacts::count(CellFate fate, int level) const {
    int number = 0;
    constexpr int parts = 8;
    for (const SeenCell& cell : cells) {
        if (fate != CellFate::empty)
            number += cell.fate == fate && cell.level == level ? 1 : 0;
        else if (cell.fate == CellFate::divided && cell.level + 1 == level)
            number += parts - cell.held;
    }
    return number;
}

int OctreeFacts::count_to(CellFate fate, int level) const {
    int number = 0;
    for (int i = 0; i <= level; ++i) number += count(fate, i);
    return number;
}

std::vector<std::pair<int, int>> OctreeFacts::held_counts(int level) const {
    std::map<int, int> counts;
    for (const SeenCell& cell : cells)
        if (cell.fate != CellFate::divided && cell.level <= level) ++counts[cell.held];
    return {counts.begin(), counts.end()};
}

std::optional<OctreeFacts> octree_facts(const Trace& trace, int ray) {
    if (std::size_t(ray) >= trace.rays.size()) return std::nullopt;
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    const auto* began = traced.find<SearchBegan>();
    if (began == nullptr) return std::nullopt;
    OctreeFacts facts;
    facts.objects = began->objects;
    for (const Event& event : traced.events) {
        if (const auto* place = std::get_if<PlaceEntered>(&event)) {
            if (place->kind == PlaceKind::part) continue;
            const bool divided = place->kind == PlaceKind::node;
            facts.cells.push_back({divided ? CellFate::divided : CellFate::tested, place->level, place->held,
                                   0, place->t_in, place->t_out});
            facts.deepest = std::max(facts.deepest, place->level + (divided ? 1 : 0));
        } else if (const auto* left = std::get_if<PlaceLeft>(&event);
                   left != nullptr && !facts.cells.empty()) {
            facts.cells.back().tested = left->tested;
            if (left->tested == 0) facts.cells.back().fate = CellFate::spared;
        } else if (const auto* ended = std::get_if<SearchEnded>(&event)) {
            facts.tested = ended->tested;
            facts.saved = ended->spared;
            facts.end = ended->t;
        }
    }
    return facts;
}

} // namespace rayscope::window
