#pragma once
// A rectangle on the screen for each object: an eye ray is tested against what its place on the screen may show.

#include "core/extents/cell_lists.hpp"
#include "core/extents/view_rectangle.hpp"
#include "core/stage/apart.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/search.hpp"
#include "core/world/camera.hpp"

namespace rayscope {

/// For eye rays alone: a mirrored ray has no place on the screen. The screen is cut into tiles; each lists the objects
/// whose rectangle meets it, nearest first, and a ray ends where the next one begins beyond its hit.
template <Numbers N> class ProjectiveExtents {
public:
    static constexpr int tile = 8; ///< pixels along an edge

    ProjectiveExtents(const World<N>& world, const EyeRays& eye_rays, int width, int height);

    /// True for rays through a pixel of the screen.
    [[nodiscard]] bool knows(const RayUse& use) const {
        return use.x >= 0 && use.x < width_ && use.y >= 0 && use.y < height_;
    }
    template <typename Search> [[gnu::noinline]] void look(const RayUse& use, Search& search) const;

    [[nodiscard]] const CellLists& lists() const { return lists_; }
    [[nodiscard]] std::size_t apart() const { return apart_.size(); }

private:
    [[nodiscard]] PlaceEntered tile_entered(const RayUse& use, int held) const;

    int width_, height_;
    CellLists lists_;
    std::vector<std::uint32_t> apart_; // tested by every ray
};

template <Numbers N>
ProjectiveExtents<N>::ProjectiveExtents(const World<N>& world, const EyeRays& eye_rays, int width, int height)
    : width_(width), height_(height) {
    std::vector<std::uint32_t> together;
    const Reach reach = sort_out(world, apart_, together);
    const Views<N> views(world, reach.margin(largest_component(absolute(eye_rays.eye()))));
    const auto frame = [&](const Vec3d& p) { return eye_rays.from_eye(p); };
    const double scale = 1 / eye_rays.pixel();
    // To a tile, which is one of the screen's own; a rectangle may reach beyond, and rounding by a part of a pixel.
    const auto tile_of = [&](double slope, double middle, double away, int size) {
        const double pixel = slope * scale + middle + away;
        return int(minimum(maximum(pixel, 0.0), double(size) - 0.5)) / tile;
    };
    std::vector<CellLists::Item> items;
    for (const std::uint32_t id : together) {
        const auto seen = views.rectangle(world.objects[id], frame);
        if (!seen) continue;
        const double rounding = 0x1p-10;
        const double half_width = 0.5 * width, half_height = 0.5 * height;
        if (seen->right * scale < -half_width - 1 || seen->left * scale > half_width + 1 ||
            seen->bottom * scale < -half_height - 1 || seen->top * scale > half_height + 1)
            continue;
        items.push_back({tile_of(seen->left, half_width, -rounding, width),
                         tile_of(seen->top, half_height, -rounding, height),
                         tile_of(seen->right, half_width, rounding, width),
                         tile_of(seen->bottom, half_height, rounding, height), below(seen->nearest), id});
    }
    lists_ = CellLists((width - 1) / tile + 1, (height - 1) / tile + 1, std::move(items));
}

template <Numbers N>
template <typename Search>
void ProjectiveExtents<N>::look(const RayUse& use, Search& search) const {
    for (const std::uint32_t object : apart_)
        if (search.test(object)) return;
    const Counters& counters = search.work().counters;
    ++search.work().counters.cells;
    const auto entries = lists_.at(use.x / tile, use.y / tile);
    const std::uint64_t before = counters.objects;
    if constexpr (Search::recording) search.recorder().record(tile_entered(use, int(entries.size())));
    for (const CellLists::Entry& entry : entries) {
        if (ScalarOf<N>(entry.nearest) > search.reach()) {
            if constexpr (Search::recording) search.leave_out();
            break;
        }
        if constexpr (Search::recording) search.recorder().record(entry_read(entry.object, entry.nearest));
        if (search.test(entry.object)) break;
    }
    if constexpr (Search::recording)
        search.recorder().record(place_left(before, counters.objects, entries.size()));
}

template <Numbers N> PlaceEntered ProjectiveExtents<N>::tile_entered(const RayUse& use, int held) const {
    const int size = tile << lists_.coarser();
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
