// Handles in the 3D view: where they are, how they look, and what catches them.

#include "visualizer/window/ray_view_parts.hpp"

#include "visualizer/drawing/labels.hpp"
#include "visualizer/drawing/ray_path.hpp"

#include <cmath>
#include <numbers>

namespace rayscope::window {
namespace {

constexpr double reach = 12; // pixels

void ring(drawing::Canvas& canvas, const drawing::Pixel& at, double radius) {
    drawing::Stroke circle{{}, drawing::ink, 1.8};
    constexpr int corners = 28;
    for (int i = 0; i <= corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        circle.points.push_back({at.x + radius * std::cos(angle), at.y + radius * std::sin(angle)});
    }
    canvas.add(circle);
}

/// Arrowheads to the four sides: it can go anywhere in the plane of the screen.
void arrows(drawing::Canvas& canvas, const drawing::Pixel& at, double from, double size) {
    for (const auto& [x, y] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const drawing::Pixel tip{at.x + x * (from + size), at.y + y * (from + size)},
            foot{at.x + x * from, at.y + y * from};
        canvas.add(drawing::FilledPolygon{
            {tip, {foot.x - y * size, foot.y + x * size}, {foot.x + y * size, foot.y - x * size}},
            drawing::ink});
    }
}

void square(drawing::Canvas& canvas, const drawing::Pixel& at, double half) {
    const auto corner = [&](double x, double y) { return drawing::Pixel{at.x + x * half, at.y + y * half}; };
    canvas.add(drawing::Stroke{
        {corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)}, drawing::ink, 1.6});
}

/// An end beyond the border is caught where the ray comes into view.
void bring_into_sight(Handle& handle, const drawing::View& view) {
    constexpr double margin = 14; // pixels
    const auto part = view.visible(view.to_view(handle.at), view.to_view(handle.other), margin);
    if (!part || part->from == 0) return;
    handle.at += (handle.other - handle.at) * part->from;
    handle.lever = 1 / (1 - part->from);
}

} // namespace

std::vector<Handle> RayView::handles() const {
    std::vector<Handle> all;
    if (!bench_ || !trace_ || !scene_) return all;
    const Scene& scene = bench_->scene;
    if (grip_)
        all.push_back({Handle::Kind::generic,
                       grip_->generic,
                       generic_title(scene, grip_->generic),
                       middle_of(scene, *grip_),
                       {}});
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        if (!scene.lights[i].directional)
            all.push_back({Handle::Kind::light, i, scene.lights[i].name, scene.lights[i].position, {}});
    const TracedRay& first = trace_->rays.front();
    const Vec3d start = first.start().origin,
                end = drawing::drawn_end(first, scene_->region.open_length()).point;
    all.push_back({Handle::Kind::ray_start, 0, "start", start, end});
    all.push_back({Handle::Kind::ray_end, 0, "end", end, start});
    if (view_) bring_into_sight(all[all.size() - 2], *view_);
    return all;
}

std::optional<QPointF> RayView::place_of(const Handle& handle) const {
    if (!view_) return std::nullopt;
    const auto pixel = view_->pixel(view_->to_view(handle.at));
    if (!pixel || pixel->x < 0 || pixel->y < 0 || pixel->x > width() || pixel->y > height())
        return std::nullopt;
    return QPointF(pixel->x, pixel->y);
}

std::optional<Handle> RayView::handle_at(QPointF at) const {
    std::optional<Handle> nearest;
    double least = reach;
    for (const Handle& handle : handles())
        if (const auto place = place_of(handle)) {
            const double away = std::hypot(place->x() - at.x(), place->y() - at.y());
            if (away >= least) continue;
            least = away;
            nearest = handle;
        }
    return nearest;
}

void RayView::set_grip(const std::optional<Grip>& grip) {
    if (grip_ == grip) return;
    grip_ = grip;
    changed(false);
}

void RayView::grip_under(QPointF at) {
    // Through the point under the mouse in the plane of the pivot that faces the camera.
    const double pixel = view_->pixel_size(Vec3d{0}) * view_->scale();
    const drawing::Pixel middle = view_->pixel(Vec3d{0}).value_or(drawing::Pixel{});
    const Vec3d through =
        orbit_.pivot + (view_->right() * (at.x() - middle.x) - view_->up() * (at.y() - middle.y)) * pixel;
    const Vec3d eye = orbit_.pivot + view_->position() * view_->scale();
    const auto seen = [this](std::size_t drawn, bool entering) {
        if (presence_of(drawn) == Presence::hidden) return false;
        // Of a room the walls before the camera are not drawn.
        return !entering || std::ranges::none_of(actors_->named.shown, [&](const drawing::Surface& surface) {
            return surface.drawn == drawn && surface.room;
        });
    };
    set_grip(grip_at(*bench_, {eye, normalized(through - eye)}, seen));
    if (on_grip) on_grip(grip_);
}

void RayView::catch_handle(QPointF at, bool whole_solid) {
    caught_.reset();
    caught_moved_ = false;
    if (whole_solid) {
        grip_under(at);
        if (grip_) caught_ = handles().front();
    } else {
        caught_ = handle_at(at);
    }
}

void RayView::drag_handle(QPointF by) {
    // In the plane through where it was caught that faces the camera, which stays as it is.
    const double pixel = view_->pixel_size(view_->to_view(caught_->at)) * view_->scale();
    const Vec3d to = caught_->at + (view_->right() * by.x() - view_->up() * by.y()) * pixel;
    if (on_drag) on_drag(*caught_, to, pixel, caught_moved_);
    caught_moved_ = true;
}

void RayView::draw_handles(drawing::Canvas& canvas, drawing::LabelPlacer& placer) const {
    for (const Handle& handle : handles()) {
        const auto place = place_of(handle);
        if (!place) continue;
        const drawing::Pixel at{place->x(), place->y()};
        switch (handle.kind) {
        case Handle::Kind::light: break; // its sun is its handle
        case Handle::Kind::generic:
            ring(canvas, at, 9);
            arrows(canvas, at, 11, 5);
            placer.place(canvas, {handle.name, at, drawing::ink, 12, drawing::Font::bold, 18});
            break;
        default: square(canvas, at, 8);
        }
    }
}

} // namespace rayscope::window
