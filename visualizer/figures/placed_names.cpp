#include "visualizer/figures/placed_names.hpp"

#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rayscope::figures {
namespace {

using drawing::Area;

Pixel middle_of(const Area& area) { return {area.x + area.width / 2, area.y + area.height / 2}; }

/// Straight up or down from the mark's edge to the name; without height where the name stands beside the mark.
Area lead_of(Pixel mark, const Area& area) {
    if (area.y <= mark.y && mark.y <= area.bottom()) return {mark.x, mark.y, 0, 0};
    const bool below = area.y > mark.y;
    const double from = mark.y + (below ? 10 : -10), to = below ? area.y : area.bottom();
    return {mark.x - 2, std::min(from, to), 4, std::abs(to - from)};
}

/// Beside the mark if it can be, otherwise above or below: the nearest first.
std::vector<Area> candidates(const NamedMark& named) {
    const drawing::Font font = named.type.bold ? drawing::Font::bold : drawing::Font::sans;
    const double width = drawing::text_width(named.name, font, named.type.size) + 8;
    const double height = named.type.size + 6;
    const Pixel mark = named.at;
    std::vector<Area> areas{{mark.x + 12, mark.y - height / 2, width, height},
                            {mark.x - 12 - width, mark.y - height / 2, width, height}};
    for (double away = 30; away < 330; away += height / 2)
        for (const double side : {-1.0, 1.0})
            for (const double before : {4.0, width / 2, width - 4})
                areas.push_back({mark.x - before, mark.y + side * away - height / 2, width, height});
    return areas;
}

class Places {
public:
    Places(const std::vector<Pixel>& marks, const std::vector<Pixel>& line, const Area& room) : room_(room) {
        for (const Pixel& p : marks) marks_.push_back({p.x - 10, p.y - 10, 20, 20});
        for (std::size_t i = 1; i < line.size(); ++i) {
            const Pixel from = line[i - 1], to = line[i];
            const double length = std::hypot(to.x - from.x, to.y - from.y);
            for (double at = 0; at < length; at += 2)
                line_.push_back({from.x + (to.x - from.x) * at / length - 2,
                                 from.y + (to.y - from.y) * at / length - 2, 4, 4});
        }
    }
    /// False: there was no place that its lead reaches past other names and marks.
    bool take(const NamedMark& named, Area& found) {
        const std::vector<Area> all = candidates(named);
        const auto is_free = [&](const Area& area) {
            return room_.contains(area) && !hits(area, marks_) && !hits(area, line_) && !hits(area, names_);
        };
        const auto is_clear = [&](const Area& area) {
            const Area lead = lead_of(named.at, area);
            return is_free(area) && (lead.height == 0 || (!hits(lead, names_) && !hits(lead, marks_)));
        };
        auto at = std::find_if(all.begin(), all.end(), is_clear);
        const bool clear = at != all.end();
        if (!clear) at = std::find_if(all.begin(), all.end(), is_free);
        if (at == all.end()) throw InputError("figures", {}, "no place for " + named.name);
        found = *at;
        names_.push_back(found);
        if (const Area lead = lead_of(named.at, found); lead.height > 0) names_.push_back(lead);
        return clear;
    }

private:
    [[nodiscard]] static bool hits(const Area& area, const std::vector<Area>& others) {
        return std::any_of(others.begin(), others.end(), [&](const Area& o) { return o.overlaps(area); });
    }
    Area room_;
    std::vector<Area> marks_, line_, names_;
};

} // namespace

std::vector<PlacedName> place_names(const std::vector<NamedMark>& names, const std::vector<Pixel>& marks,
                                    const std::vector<Pixel>& line, const Area& room) {
    std::vector<std::size_t> order(names.size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    // The long ones first: they find the fewest places. Who finds none goes before all others in the next try.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return names[a].name.size() > names[b].name.size();
    });
    std::vector<Area> areas(names.size());
    for (std::size_t tries = 0; tries <= names.size(); ++tries) {
        Places places(marks, line, room);
        auto crossing = order.end();
        for (auto at = order.begin(); at != order.end(); ++at)
            if (!places.take(names[*at], areas[*at]) && crossing == order.end()) crossing = at;
        if (crossing == order.end()) break;
        std::rotate(order.begin(), crossing, crossing + 1);
    }
    std::vector<PlacedName> placed;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Area lead = lead_of(names[i].at, areas[i]);
        const double x = names[i].at.x;
        placed.push_back({middle_of(areas[i]), {x, lead.y}, {x, lead.bottom()}});
    }
    return placed;
}

} // namespace rayscope::figures
