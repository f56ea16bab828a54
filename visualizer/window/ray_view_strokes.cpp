// Rays, hits, lanes and labels of the 3D view.

#include "visualizer/window/ray_view_parts.hpp"

#include "visualizer/drawing/legend.hpp"
#include "visualizer/drawing/marks.hpp"
#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/trace_geometry.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::window {
namespace {

constexpr double letters = 12;

/// The trace's tables with one ray alone: what is drawn of that ray only needs no geometry of the others.
/// @param deepest level of the cells that are kept
Trace alone(const Trace& trace, int ray, int deepest) {
    Trace single;
    single.source = trace.source;
    single.eye = trace.eye;
    single.objects = trace.objects;
    single.generics = trace.generics;
    single.media = trace.media;
    single.lights = trace.lights;
    single.rays = {trace.rays[std::size_t(ray)]};
    single.rays.front().parent = none;
    single.rays.front().children.clear();
    std::erase_if(single.rays.front().events, [&](const Event& event) {
        const auto* place = std::get_if<PlaceEntered>(&event);
        return place != nullptr && place->level > deepest;
    });
    return single;
}

double distance_to(QPointF p, const drawing::Pixel& a, const drawing::Pixel& b) {
    const double dx = b.x - a.x, dy = b.y - a.y, size = dx * dx + dy * dy;
    const double s = size > 0 ? std::clamp(((p.x() - a.x) * dx + (p.y() - a.y) * dy) / size, 0.0, 1.0) : 0;
    return std::hypot(p.x() - a.x - s * dx, p.y() - a.y - s * dy);
}

} // namespace

void RayView::draw_strokes() {
    const drawing::Region& region = scene_->region;
    if (actors_->rays == nullptr) {
        actors_->rays = drawing::rays_polydata(*trace_, region.open_length());
        actors_->hits = drawing::hits_polydata(*trace_);
    }
    drawing::RayStrokes strokes(*view_, drawing::Region{orbit_.pivot, orbit_.radius, {}}, 1);
    strokes.draw(*trace_, styles_, actors_->rays, actors_->hits);
    const Trace single = alone(*trace_, ray_, deepest_cell_);
    const drawing::Lanes lanes = drawing::lanes_of(single, single.rays.front(), 8);
    strokes.draw_places(0, drawing::places_polydata(single));
    strokes.draw_lanes(single, 0, lanes, drawing::spans_polydata(single, region.open_length()));
    drawing::Mesh mesh = strokes.mesh();
    if (sweep_) {
        const RaySpawned& start = single.rays.front().start();
        const Vec3d at = view_->to_view(start.origin + start.direction * *sweep_);
        if (length(at) < 1e6) mesh.add_ball(at, 6 * view_->pixel_size(at), drawing::hit_purple);
    }
    actors_->show_strokes(mesh);

    drawing::Canvas canvas;
    const bool ghosts = trace_->rays.size() > 1;
    const double wide = width() - 2 * letters,
                 high = drawing::draw_legend(nullptr, letters, 0, wide, *trace_, ghosts, letters * 0.95) +
                        letters * 0.5;
    drawing::Area free = area();
    free.height -= high;
    drawing::LabelPlacer placer(free, strokes.segments());
    drawing::draw_marks(canvas, placer, *trace_, styles_, actors_->named, *scene_->bench,
                        drawing::Region{orbit_.pivot, orbit_.radius, {}}, *view_, letters);
    draw_handles(canvas, placer);
    canvas.add(drawing::FilledArea{{0, free.height, double(width()), high}, drawing::paper, 0.85});
    drawing::draw_legend(&canvas, letters, free.height + letters * 0.25, wide, *trace_, ghosts,
                         letters * 0.95);
    actors_->show_canvas(std::move(canvas), height(), std::max(1, int(std::lround(devicePixelRatioF()))));
}

int RayView::ray_at(QPointF at) const {
    constexpr double reach = 9; // pixels
    double best = reach;
    int found = none;
    for (const drawing::RayStyle& style : styles_) {
        const TracedRay& ray = trace_->rays[std::size_t(style.ray)];
        const Vec3d from = view_->to_view(ray.start().origin),
                    to = view_->to_view(drawing::drawn_end(ray, scene_->region.open_length()).point);
        const auto part = view_->visible(from, to, 0);
        if (!part) continue;
        const auto a = view_->pixel(from + (to - from) * part->from),
                   b = view_->pixel(from + (to - from) * part->to);
        if (!a || !b) continue;
        const double away = distance_to(at, *a, *b);
        if (away < best) {
            best = away;
            found = style.ray;
        }
    }
    return found;
}

std::optional<QPoint> RayView::place_of(int id) const {
    if (!view_ || !scene_ || id < 0 || std::size_t(id) >= trace_->rays.size()) return std::nullopt;
    const TracedRay& ray = trace_->rays[std::size_t(id)];
    const Vec3d from = view_->to_view(ray.start().origin),
                to = view_->to_view(drawing::drawn_end(ray, scene_->region.open_length()).point);
    const auto part = view_->visible(from, to, 4);
    if (!part) return std::nullopt;
    const auto pixel = view_->pixel(from + (to - from) * ((part->from + part->to) / 2));
    return pixel ? std::optional(QPoint(int(pixel->x), int(pixel->y))) : std::nullopt;
}

} // namespace rayscope::window
