#pragma once
// Projective extents once more, as a light sees them (the light buffer: Haines and Greenberg 1986).

#include "core/extents/cell_lists.hpp"
#include "core/extents/light_view.hpp"
#include "core/extents/view_rectangle.hpp"
#include "core/stage/ball_filter.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/search.hpp"
#include "core/stage/unboxed.hpp"

namespace rayscope {

/// For shadow rays: what can stand between a point and a light is seen by the light in the direction of that point. Each
/// cell around the light lists what is seen through it, nearest to the light first; and the distance from which on an
/// opaque ball covers the whole cell: what lies beyond is dark without a test.
template <Numbers N> class LightExtents {
public:
    explicit LightExtents(const World<N>& world);

    template <typename Search> [[gnu::noinline]] void look(const RayUse& use, Search& search) const;

    [[nodiscard]] std::size_t entries() const;
    [[nodiscard]] std::size_t bytes() const;
    /// For people: one, six where the light stands among the objects, none where there are none or the light has an area.
    [[nodiscard]] std::vector<LightWindow> windows_of(std::size_t light) const;

private:
    struct Window {
        LightView view;
        CellLists lists;
        std::vector<float> covered; ///< by cell: the distance from which on all is dark
    };
    struct LightsView {
        std::vector<Window> windows;
        Unboxed<N> aside; ///< so large that a window for them would have no cells left for the others
    };
    using Rectangles = std::vector<std::optional<ViewRectangle>>; // of the objects together_

    [[nodiscard]] PlaceEntered cell_entered(const Window& window, const LightView::Cell& cell, int held,
                                            double distance) const;
    [[nodiscard]] LightsView view_of(const Light& light) const;
    [[nodiscard]] Rectangles rectangles(const LightView& view) const;
    [[nodiscard]] std::vector<std::uint32_t> set_aside(Rectangles& rectangles) const;
    [[nodiscard]] bool fit(LightView& view, const Rectangles& rectangles) const;
    [[nodiscard]] Window window(const LightView& view, const Rectangles& rectangles) const;
    void cover(Window& window, const Object& object, const CellLists::Item& item) const;

    const World<N>& world_;
    BallFilter<N> balls_;
    Unboxed<N> apart_;
    std::vector<std::uint32_t> together_;
    Reach reach_;
    double farthest_ = 0, margin_ = 0; // where rays may start; by how much objects are larger for it
    std::vector<LightsView> lights_;
};

template <Numbers N>
template <typename Search>
void LightExtents<N>::look(const RayUse& use, Search& search) const {
    const Vec3d from = as<double>(search.ray().origin);
    const LightsView& light = lights_[std::size_t(use.light)];
    if (light.windows.empty() || !(largest_component(absolute(from)) <= farthest_)) {
        const SlabRay<double> ray(as<double>(search.ray()), reach_.size(), reach_.distortion);
        if (!ray.reliable() || ray.may_hit(reach_.bounds, double(search.reach())))
            for (const std::uint32_t object : together_)
                if (search.test(object)) return;
    } else {
        for (const Window& window : light.windows) {
            const Vec3d seen = window.view.from_light(from);
            const auto cell = window.view.cell(seen);
            if (!cell) continue;
            const Counters& counters = search.work().counters;
            ++search.work().counters.cells;
            const double distance = window.view.distance(seen);
            const double beyond = double(above(distance));
            const auto entries = window.lists.at(cell->x, cell->y);
            const std::uint64_t before = counters.objects;
            if constexpr (Search::recording)
                search.recorder().record(cell_entered(window, *cell, int(entries.size()), distance));
            if (distance > double(window.covered[std::size_t(cell->y * window.view.cells + cell->x)])) {
                if constexpr (requires { search.covered(); }) search.covered();
                return;
            }
            for (const CellLists::Entry& entry : entries) {
                if (double(entry.nearest) > beyond) {
                    if constexpr (Search::recording) search.leave_out();
                    break;
                }
                if constexpr (Search::recording)
                    search.recorder().record(entry_read(entry.object, entry.nearest));
                if (!balls_.misses(entry.object, search.ray(), search.work().counters) &&
                    search.test(entry.object))
                    return;
            }
            if constexpr (Search::recording)
                search.recorder().record(place_left(before, counters.objects, entries.size()));
            break;
        }
        if (light.aside.test(search)) return;
    }
    (void)apart_.test(search);
}

template <Numbers N>
PlaceEntered LightExtents<N>::cell_entered(const Window& window, const LightView::Cell& cell, int held,
                                           double distance) const {
    PlaceEntered entered;
    entered.kind = PlaceKind::light_cell;
    entered.place = cell.y * window.view.cells + cell.x;
    entered.held = held;
    entered.low = entered.high = {cell.x, cell.y, 0};
    entered.t_out = distance;
    return entered;
}

extern template class LightExtents<double>;

} // namespace rayscope
