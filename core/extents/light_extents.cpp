#include "core/extents/light_extents.hpp"

namespace rayscope {
namespace {

constexpr double cell_rounding = 0x1p-10; // of a cell: far above rounding
constexpr double steepest = 4;            // slope that a single window still looks at
constexpr std::size_t cover_looks_per_cell = 16;

int cells_for(std::size_t objects) {
    int cells = 16; // measured: more than 256² cost more to fill than their shorter lists save
    while (cells < 256 && double(cells) * cells < 4 * double(objects)) cells *= 2;
    return cells;
}

} // namespace

template <Numbers N> LightExtents<N>::LightExtents(const World<N>& world) : world_(world), balls_(world) {
    std::vector<std::uint32_t> apart;
    reach_ = sort_out(world, apart, together_);
    apart_ = Unboxed<N>(world, apart);
    farthest_ = 1024 * reach_.size();
    margin_ = reach_.margin(farthest_);
    for (const Light& light : world.lights)
        lights_.push_back(together_.empty() || light.area.is_sampled() ? LightsView{} : view_of(light));
}

template <Numbers N> auto LightExtents<N>::view_of(const Light& light) const -> LightsView {
    LightsView result;
    LightView view;
    view.parallel = light.directional;
    view.position = light.position;
    view.cells = cells_for(together_.size());
    const Vec3d middle = (reach_.bounds.low + reach_.bounds.high) / 2.0;
    const Vec3d towards = light.directional ? -light.position : middle - light.position;
    if (length(towards) > 0) {
        view.look(towards);
        Rectangles seen = rectangles(view);
        const bool all_before = std::ranges::all_of(seen, [](const auto& r) { return r.has_value(); });
        std::vector<std::uint32_t> aside;
        if (all_before) aside = set_aside(seen);
        if (all_before && fit(view, seen)) {
            result.aside = Unboxed<N>(world_, aside);
            result.windows.push_back(window(view, seen));
            return result;
        }
    }
    // The light stands among the objects: the six sides of a cube around it.
    constexpr double overlap = 8 * double(epsilon<float>); // of neighbouring sides
    view.left = view.top = -1 - overlap;
    view.width = view.height = 2 + 2 * overlap;
    view.cells = std::max(16, view.cells / 2);
    view.cut();
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0}) {
            Vec3d direction{0};
            direction[axis] = side;
            view.look(direction);
            result.windows.push_back(window(view, rectangles(view)));
        }
    return result;
}

template <Numbers N> auto LightExtents<N>::rectangles(const LightView& view) const -> Rectangles {
    const Views<N> views(world_, margin_);
    const auto frame = [&](const Vec3d& p) { return view.from_light(p); };
    Rectangles result;
    for (const std::uint32_t id : together_) {
        const Object& object = world_.objects[id];
        result.push_back(view.parallel ? views.parallel_rectangle(object, frame)
                                       : views.rectangle(object, frame));
    }
    return result;
}

// A floor under everything would be given most of the cells: it, and a few others like it, are tested by every shadow ray
// instead. They are taken out of the rectangles.
template <Numbers N> std::vector<std::uint32_t> LightExtents<N>::set_aside(Rectangles& rectangles) const {
    constexpr std::size_t most = 4;
    constexpr double much = 4; // times the area of all others
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < rectangles.size(); ++i)
        if (rectangles[i]) order.push_back(i);
    const auto area = [](const ViewRectangle& r) { return (r.right - r.left) * (r.bottom - r.top); };
    const std::size_t large = std::min(most, order.size());
    std::partial_sort(
        order.begin(), order.begin() + std::ptrdiff_t(large), order.end(),
        [&](std::size_t a, std::size_t b) { return area(*rectangles[a]) > area(*rectangles[b]); });
    ViewRectangle rest;
    const auto include = [&](const ViewRectangle& r) {
        rest.include(r.left, r.top);
        rest.include(r.right, r.bottom);
    };
    for (std::size_t i = large; i < order.size(); ++i) include(*rectangles[order[i]]);
    std::vector<std::uint32_t> aside;
    for (std::size_t i = large; i-- > 0;) { // from the smallest of the large ones on
        const ViewRectangle before = rest;
        include(*rectangles[order[i]]);
        if (i + 1 == large && large == order.size()) continue;
        if (!(area(rest) > much * area(before))) continue;
        for (std::size_t k = 0; k <= i; ++k) {
            aside.push_back(together_[order[k]]);
            rectangles[order[k]].reset();
        }
        break;
    }
    return aside;
}

// One window for all objects, where they lie in front of the light.
template <Numbers N> bool LightExtents<N>::fit(LightView& view, const Rectangles& rectangles) const {
    ViewRectangle all;
    for (const auto& seen : rectangles) {
        if (!seen) continue;                               // set aside
        if (seen->left == -infinity<double>) return false; // it reaches the light's plane
        all.include(seen->left, seen->top);
        all.include(seen->right, seen->bottom);
    }
    const double widest = maximum(maximum(-all.left, all.right), maximum(-all.top, all.bottom));
    if (!(widest < (view.parallel ? infinity<double> : steepest))) return false;
    const double edge = 2 * cell_rounding / view.cells;
    view.width = (all.right - all.left) * (1 + 2 * edge);
    view.height = (all.bottom - all.top) * (1 + 2 * edge);
    view.left = all.left - edge * (all.right - all.left);
    view.top = all.top - edge * (all.bottom - all.top);
    view.cut();
    return view.width > 0 && view.height > 0;
}

template <Numbers N>
auto LightExtents<N>::window(const LightView& view, const Rectangles& rectangles) const -> Window {
    Window result{view, {}, {}};
    const auto cell = [&](double place) {
        return int(minimum(maximum(place, 0.0), double(view.cells) - 0.5));
    };
    std::vector<CellLists::Item> items;
    for (std::size_t i = 0; i < together_.size(); ++i) {
        const auto& seen = rectangles[i];
        if (!seen) continue;
        const double left = view.column(seen->left) - cell_rounding,
                     top = view.row(seen->top) - cell_rounding;
        const double right = view.column(seen->right) + cell_rounding,
                     bottom = view.row(seen->bottom) + cell_rounding;
        if (right < 0 || bottom < 0 || left > view.cells || top > view.cells) continue;
        items.push_back(
            {cell(left), cell(top), cell(right), cell(bottom), below(seen->nearest), together_[i]});
    }
    result.covered.assign(std::size_t(view.cells) * std::size_t(view.cells), infinity<float>);
    CellLists::nearest_first(items); // covers too: what lies behind them covers nothing that is not covered
    std::size_t looks = cover_looks_per_cell * result.covered.size() + 64 * items.size();
    for (const CellLists::Item& item : items) {
        const Object& object = world_.objects[item.object];
        if (!world_.is_ball(object) || world_.material_of(object).transmits()) continue;
        const std::size_t cells =
            std::size_t(item.right - item.left + 1) * std::size_t(item.bottom - item.top + 1);
        if (cells > looks) continue; // covers save time, and may not cost it
        looks -= cells;
        cover(result, object, item);
    }
    result.lists = CellLists(view.cells, view.cells, items);
    return result;
}

// A cell whose corners lie within the ball's outline lies within it as a whole.
template <Numbers N>
void LightExtents<N>::cover(Window& window, const Object& object, const CellLists::Item& item) const {
    const Solid<N>& ball = world_.solids[object.index];
    const LightView& view = window.view;
    const Vec3d centre = view.from_light(as<double>(ball.transform.translation()));
    const double radius = double(std::get<Sphere<N>>(ball.shape).radius);
    const double surely = radius * (1 - 8 * double(epsilon<float>)) - margin_,
                 from_light = view.distance(centre);
    if (!(surely > 0) || (!view.parallel && from_light <= radius + margin_)) return;
    const auto hides = [&](double column, double row) {
        const double x = view.left + column * view.width / view.cells,
                     y = view.top + row * view.height / view.cells;
        if (view.parallel) return std::hypot(x - centre.x, y - centre.y) < surely;
        const Vec3d direction{x, y, 1}, aside = cross(direction, centre);
        return dot(direction, centre) > 0 && dot(aside, aside) < surely * surely * dot(direction, direction);
    };
    const float beyond = above(from_light + radius + margin_);
    for (int y = item.top + 1; y < item.bottom; ++y)
        for (int x = item.left + 1; x < item.right; ++x) {
            float& covered = window.covered[std::size_t(y * view.cells + x)];
            if (covered <= beyond) continue;
            const double left = x - cell_rounding, right = x + 1 + cell_rounding, top = y - cell_rounding,
                         bottom = y + 1 + cell_rounding;
            if (!hides(left, top) || !hides(right, top) || !hides(left, bottom) || !hides(right, bottom))
                continue;
            covered = beyond;
        }
}

template <Numbers N> std::size_t LightExtents<N>::entries() const {
    std::size_t sum = 0;
    for (const LightsView& view : lights_)
        for (const Window& window : view.windows) sum += window.lists.size();
    return sum;
}

template <Numbers N> std::size_t LightExtents<N>::bytes() const {
    std::size_t sum = balls_.bytes();
    for (const LightsView& view : lights_)
        for (const Window& window : view.windows)
            sum += window.lists.bytes() + window.covered.capacity() * sizeof(float);
    return sum;
}

template <Numbers N> std::vector<LightWindow> LightExtents<N>::windows_of(std::size_t light) const {
    std::vector<LightWindow> result;
    for (const Window& window : lights_.at(light).windows) {
        LightWindow& seen = result.emplace_back(LightWindow{window.view, {}});
        for (int y = 0; y < window.view.cells; ++y)
            for (int x = 0; x < window.view.cells; ++x) seen.held.push_back(window.lists.at(x, y).size());
    }
    return result;
}

template class LightExtents<double>;

} // namespace rayscope
