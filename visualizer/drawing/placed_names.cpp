#include "visualizer/drawing/placed_names.hpp"

#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace rayscope::drawing {
namespace {

// In units of the letters' size.
constexpr double mark_radius = 0.56, beside_mark = 0.67, first_away = 1.67, last_away = 18, rim = 0.22;
constexpr double crossing = 1e5, no_place = 1e9; // dearer than any lead's length
constexpr int good_tries = 300, most_tries = 20000, most_left = 12;

/// Straight up or down from the mark's edge to the name; without height where the name stands beside the mark.
Area lead_of(const NamedMark& named, const Area& area) {
    const Pixel mark = named.at;
    if (area.y <= mark.y && mark.y <= area.bottom()) return {mark.x, mark.y, 0, 0};
    const bool below = area.y > mark.y;
    const double away = mark_radius * named.size + 1; // not into a neighbour whose height differs by nothing
    const double from = mark.y + (below ? away : -away), to = below ? area.y : area.bottom();
    return {mark.x - 2, std::min(from, to), 4, std::abs(to - from)};
}

/// Beside the mark if it can be, otherwise above or below: the nearest first.
std::vector<Area> candidates(const NamedMark& named) {
    const double size = named.size, gap = rim * size;
    const double width = text_width(named.name, named.font, size) + 2 * gap, height = 1.33 * size;
    const Pixel mark = named.at;
    std::vector<Area> areas{{mark.x + beside_mark * size, mark.y - height / 2, width, height},
                            {mark.x - beside_mark * size - width, mark.y - height / 2, width, height}};
    for (double away = first_away * size; away < last_away * size; away += height / 2)
        for (const double side : {-1.0, 1.0})
            for (const double before : {gap, width / 2, width - gap})
                areas.push_back({mark.x - before, mark.y + side * away - height / 2, width, height});
    return areas;
}

class Places {
public:
    Places(const std::vector<Pixel>& marks, const std::vector<Pixel>& line, const Area& room, double size)
        : room_(room) {
        const double radius = mark_radius * size;
        for (const Pixel& p : marks) marks_.push_back({p.x - radius, p.y - radius, 2 * radius, 2 * radius});
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Pixel from = line[i - 1], to = line[i];
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            for (double at = 0; at < length; at += 2)
                line_.push_back({from.x + (to.x - from.x) * at / length - 2,
                                 from.y + (to.y - from.y) * at / length - 2, 4, 4});
        }
    }
    /// @param all places that the name may have
    /// @param left_to_others how many good ones it leaves
    /// @return what the one that it takes costs: the length of its lead; much more if that crosses a name or a mark, or if
    /// there is no place
    double take(const NamedMark& named, const std::vector<Area>& all, int left_to_others,
                std::optional<PlacedName>& placed) {
        const auto is_free = [&](const Area& area) {
            return room_.contains(area) && !hits(area, marks_) && !hits(area, line_) && !hits(area, names_);
        };
        const auto is_clear = [&](const Area& area) {
            const Area lead = lead_of(named, area);
            return is_free(area) && (lead.height == 0 || (!hits(lead, names_) && !hits(lead, marks_)));
        };
        auto at = std::find_if(all.begin(), all.end(),
                               [&](const Area& area) { return is_clear(area) && left_to_others-- == 0; });
        const bool clear = at != all.end();
        if (!clear) at = std::find_if(all.begin(), all.end(), is_free);
        placed.reset();
        if (at == all.end()) return no_place;
        placed = {*at, {}};
        names_.push_back(*at);
        const Area lead = lead_of(named, *at);
        if (lead.height > 0) {
            names_.push_back(lead);
            placed->lead = {{named.at.x, lead.y}, {named.at.x, lead.bottom()}};
        }
        return lead.height + (clear ? 0 : crossing);
    }

private:
    [[nodiscard]] static bool hits(const Area& area, const std::vector<Area>& others) {
        return std::any_of(others.begin(), others.end(), [&](const Area& o) { return o.overlaps(area); });
    }
    Area room_;
    std::vector<Area> marks_, line_, names_;
};

} // namespace

std::vector<std::optional<PlacedName>> place_names(const std::vector<NamedMark>& names,
                                                   const std::vector<Pixel>& marks,
                                                   const std::vector<Pixel>& line, const Area& room) {
    std::vector<std::optional<PlacedName>> best(names.size()), placed(names.size());
    if (names.empty()) return best;
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::vector<std::vector<Area>> all;
    for (const NamedMark& named : names) all.push_back(candidates(named));
    double least = infinity<double>;
    // Who comes first takes places from the others, and which order is good can't be told beforehand. Where none is, some
    // leave the nearest places.
    std::mt19937 random(1);
    const Places no_names(marks, line, room, names.front().size);
    for (int tries = 0; tries < good_tries || (least >= crossing && tries < most_tries); ++tries) {
        Places places = no_names;
        double cost = 0;
        for (const std::size_t i : order) {
            const bool leaves = tries >= good_tries && random() % 8 == 0;
            const int left_to_others = leaves ? 1 + int(random() % most_left) : 0;
            cost += places.take(names[i], all[i], left_to_others, placed[i]);
        }
        if (cost < least) {
            least = cost;
            best = placed;
        }
        for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    }
    return best;
}

} // namespace rayscope::drawing
