#pragma once
// A rectangle on the screen for each object: an eye ray is tested against what its place on the screen may show.

#include "core/extents/cell_lists.hpp"
#include "core/extents/view_rectangle.hpp"
#include "core/stage/ball_filter.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/search.hpp"
#include "core/stage/unboxed.hpp"
#include "core/world/camera.hpp"

namespace rayscope {

/// What an object covers of the screen, in pixels; it may reach beyond the screen.
struct ScreenRectangle {
    double left, top, right, bottom;
    double nearest; ///< from the eye to the object, never rounded up
    std::uint32_t object;
};

/// The rectangles of all objects that the screen shows.
struct ScreenView {
    std::vector<ScreenRectangle> rectangles;
    std::vector<std::uint32_t> apart; ///< objects that have none: see sort_out
};
template <Numbers N>
[[nodiscard]] ScreenView screen_view(const World<N>& world, const EyeRays& eye_rays, int width, int height) {
    ScreenView view;
    std::vector<std::uint32_t> together;
    const Reach reach = sort_out(world, view.apart, together);
    const Views<N> views(world, reach.margin(largest_component(absolute(eye_rays.eye()))));
    const auto frame = [&](const Vec3d& p) { return eye_rays.from_eye(p); };
    const double scale = 1 / eye_rays.pixel(), half_width = 0.5 * width, half_height = 0.5 * height;
    for (const std::uint32_t id : together) {
        const auto seen = views.rectangle(world.objects[id], frame);
        if (!seen) continue;
        const ScreenRectangle r{seen->left * scale + half_width,
                                seen->top * scale + half_height,
                                seen->right * scale + half_width,
                                seen->bottom * scale + half_height,
                                seen->nearest,
                                id};
        if (r.right >= -1 && r.left <= width + 1 && r.bottom >= -1 && r.top <= height + 1)
            view.rectangles.push_back(r);
    }
    return view;
}

/// For eye rays alone: a mirrored ray has no place on the screen. The screen is cut into tiles; each lists the objects
/// whose rectangle meets it, nearest first, and a ray ends where the next one begins beyond its hit.
template <Numbers N> class ProjectiveExtents {
public:
    /// @param view of the world, on a screen of this size
    ProjectiveExtents(const World<N>& world, const ScreenView& view, int width, int height);

    /// True for rays through a pixel of the screen.
    [[nodiscard]] bool knows(const RayUse& use) const {
        return use.x >= 0 && use.x < width_ && use.y >= 0 && use.y < height_;
    }
    template <typename Search> [[gnu::noinline]] void look(const RayUse& use, Search& search) const;

    [[nodiscard]] std::size_t bytes() const { return lists_.bytes() + balls_.bytes(); }
    /// Edge of the tiles that share a list: smaller where many objects share the screen, larger where many cover it.
    [[nodiscard]] int tile_pixels() const { return 1 << (tile_bits_ + lists_.coarser()); }
    /// What is tested by the eye ray through a pixel, nearest first.
    [[nodiscard]] std::span<const CellLists::Entry> list_at(int x, int y) const {
        return lists_.at(x >> tile_bits_, y >> tile_bits_);
    }

private:
    [[nodiscard]] PlaceEntered tile_entered(const RayUse& use, int held) const;

    static constexpr double least_share = 0.125; // of the objects: as many tiles at least, measured

    int width_, height_;
    int tile_bits_ = 3; // binary logarithm of an edge
    CellLists lists_;
    BallFilter<N> balls_;
    Unboxed<N> apart_;
};

template <Numbers N>
ProjectiveExtents<N>::ProjectiveExtents(const World<N>& world, const ScreenView& view, int width, int height)
    : width_(width), height_(height), balls_(world), apart_(world, view.apart) {
    const auto tiles_along = [&](int size) { return ((size - 1) >> tile_bits_) + 1; };
    const double least = least_share * double(view.rectangles.size());
    while (tile_bits_ > 0 && double(tiles_along(width)) * tiles_along(height) < least) --tile_bits_;
    // To a tile, which is one of the screen's own; a rectangle may reach beyond, and rounding by a part of a pixel.
    constexpr double rounding = 0x1p-10;
    const auto tile_of = [&](double pixel, int size) {
        return int(minimum(maximum(pixel, 0.0), double(size) - 0.5)) >> tile_bits_;
    };
    std::vector<CellLists::Item> items;
    for (const ScreenRectangle& r : view.rectangles)
        items.push_back({tile_of(r.left - rounding, width), tile_of(r.top - rounding, height),
                         tile_of(r.right + rounding, width), tile_of(r.bottom + rounding, height),
                         below(r.nearest), r.object});
    CellLists::nearest_first(items);
    lists_ = CellLists(tiles_along(width), tiles_along(height), items);
}

template <Numbers N>
template <typename Search>
void ProjectiveExtents<N>::look(const RayUse& use, Search& search) const {
    if (apart_.test(search)) return;
    const Counters& counters = search.work().counters;
    ++search.work().counters.cells;
    const auto entries = list_at(use.x, use.y);
    const std::uint64_t before = counters.objects;
    if constexpr (Search::recording) search.recorder().record(tile_entered(use, int(entries.size())));
    for (const CellLists::Entry& entry : entries) {
        if (ScalarOf<N>(entry.nearest) > search.reach()) {
            if constexpr (Search::recording) search.leave_out();
            break;
        }
        if constexpr (Search::recording) search.recorder().record(entry_read(entry.object, entry.nearest));
        if (!balls_.misses(entry.object, search.ray(), search.work().counters) && search.test(entry.object))
            break;
    }
    if constexpr (Search::recording)
        search.recorder().record(place_left(before, counters.objects, entries.size()));
}

template <Numbers N> PlaceEntered ProjectiveExtents<N>::tile_entered(const RayUse& use, int held) const {
    const int size = tile_pixels();
    const int column = use.x / size, row = use.y / size;
    PlaceEntered entered;
    entered.kind = PlaceKind::tile;
    entered.place = row * ((width_ - 1) / size + 1) + column;
    entered.held = held;
    entered.low = {column * size, row * size, 0};
    entered.high = {std::min((column + 1) * size, width_) - 1, std::min((row + 1) * size, height_) - 1, 0};
    entered.t_out = infinity<double>;
    return entered;
}

} // namespace rayscope
