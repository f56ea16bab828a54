#include "visualizer/window/ray_view.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/scene_objects.hpp"
#include "visualizer/window/memory.hpp"
#include "visualizer/window/ray_view_parts.hpp"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace rayscope::window {
namespace {

// Rays of a trace of thousands that are drawn: the current one's path and what it spawned come first, then the heaviest.
constexpr std::size_t most_rays_drawn = 600;
constexpr int refine_after = 300; // milliseconds

} // namespace

RayView::RayView() : actors_(std::make_unique<Actors>()), worker_(this) {
    setObjectName("space");
    setAccessibleName("The rays in space");
    setFocusPolicy(Qt::ClickFocus);
    setMinimumSize(220, 160);
    setToolTip("Left drag: turn. Right drag: move. Wheel: zoom. Click on a ray: go there.\nDrag a light, the "
               "square at an "
               "end of the first ray, or the ring of the chosen solid: move it.\nCtrl + drag on a solid: "
               "choose and move it.");
    setMouseTracking(true); // the cursor tells what can be caught
    setRenderWindow(actors_->window);
    settle_timer_.setSingleShot(true);
    refine_timer_.setSingleShot(true);
    QObject::connect(&refine_timer_, &QTimer::timeout, this, [this] {
        render(true);
        give_back_memory(); // of what was drawn before
    });
    QObject::connect(&settle_timer_, &QTimer::timeout, this, [this] {
        moving_ = false;
        changed(true);
    });
}

RayView::~RayView() = default;

drawing::Area RayView::area() const {
    return {0, 0, double(std::max(width(), 1)), double(std::max(height(), 1))};
}

void RayView::show_trace(std::shared_ptr<const Workbench> bench, const Trace& trace, int ray, bool frame) {
    const bool other_scene = bench != bench_;
    if (frame && other_scene) {
        presence_.clear();
        exploded_.clear();
        grip_.reset();
    }
    bench_ = std::move(bench);
    trace_ = std::make_shared<Trace>(trace);
    ray_ = ray;
    sweep_.reset();
    actors_->rays = nullptr; // of the trace before
    if (scene_ != nullptr && !frame) changed(false);
    make_scenery(frame);
}

void RayView::make_scenery(bool frame) {
    frame = frame || scene_ == nullptr;
    worker_.run([this, bench = bench_, trace = trace_, exploded = exploded_, old = scene_, frame,
                 held = caught_.has_value()](const std::atomic<bool>&) {
        auto scenery = std::make_shared<Scenery>(*bench, *trace, exploded, frame ? nullptr : old.get());
        scenery->bench = bench;
        // Under a hand that drags the camera must not jump.
        const bool look = frame || (scenery->moved && !held);
        worker_.hand_over([this, scenery, look] { take(scenery, look); });
    });
}

void RayView::take(std::shared_ptr<const Scenery> scenery, bool frame) {
    scene_ = std::move(scenery);
    if (frame) orbit_ = framed_orbit(*trace_, bench_->scene, scene_->region, area(), ray_);
    changed(true);
}

void RayView::show_ray(int ray) {
    ray_ = ray;
    sweep_.reset();
    if (locked_ && scene_ != nullptr) {
        const TracedRay& traced = trace_->rays[std::size_t(ray)];
        const auto end = drawing::drawn_end(traced, scene_->region.open_length() / 2);
        orbit_.pivot = end.point;
        changed(true);
        return;
    }
    changed(false);
}

void RayView::set_sweep(std::optional<double> t) {
    if (t == sweep_) return;
    sweep_ = t;
    changed(false);
}

void RayView::set_least_weight(double weight) {
    least_weight_ = weight;
    changed(false);
}

void RayView::set_deepest_cell(int level) {
    if (level == std::exchange(deepest_cell_, level)) return;
    changed(false);
}

void RayView::set_presence(std::map<std::size_t, Presence> presence) {
    presence_ = std::move(presence);
    changed(true);
}

void RayView::set_exploded(std::set<std::size_t> drawn) {
    exploded_ = std::move(drawn);
    if (trace_) make_scenery(false);
}

void RayView::fit() {
    if (!scene_) return;
    orbit_ = framed_orbit(*trace_, bench_->scene, scene_->region, area(), ray_);
    changed(true);
}

void RayView::look_along_ray() {
    if (!scene_) return;
    const TracedRay& ray = trace_->rays[std::size_t(ray_)];
    const Vec3d to = drawing::drawn_end(ray, scene_->region.open_length()).point, from = ray.start().origin;
    // From a little behind and above: a line seen from its end is a point.
    const Vec3d d = to - from;
    orbit_.look(from - d * 0.25 + orbit_.up * (0.06 * length(d)), to);
    changed(true);
}

void RayView::look_from_eye() {
    if (!scene_) return;
    const TracedRay& first = trace_->rays.front();
    const Vec3d to = drawing::drawn_end(first, scene_->region.open_length()).point;
    orbit_.look(first.start().origin, to);
    changed(true);
}

void RayView::set_locked(bool locked) {
    locked_ = locked;
    if (locked && trace_) show_ray(ray_);
}

void RayView::turn(double dx, double dy) {
    orbit_.turn(dx, dy);
    changed(true);
}

void RayView::zoom(double factor) {
    orbit_.zoom(factor);
    changed(true);
}

void RayView::changed(bool surfaces) {
    surfaces_changed_ = surfaces_changed_ || surfaces;
    // Before the window's panels are painted, so that all of them come to the screen at once: that is half the work.
    if (!std::exchange(draw_posted_, true))
        QCoreApplication::postEvent(this, new QEvent(draw_event), Qt::HighEventPriority);
}

void RayView::finish() {
    if (settle_timer_.isActive()) {
        settle_timer_.stop();
        moving_ = false;
        surfaces_changed_ = true;
        draw();
    }
    if (draw_posted_) draw();
}

void RayView::draw() {
    draw_posted_ = false;
    if (!scene_ || !trace_) return;
    if (moving_) {
        aim();
    } else {
        if (surfaces_changed_ || !view_) {
            view_.emplace(orbit_.view(area()));
            draw_surfaces();
        }
        surfaces_changed_ = false;
        styles_ = drawing::ray_styles(*trace_, trace_->rays.size() > 1 ? std::optional(ray_) : std::nullopt);
        std::erase_if(styles_, [&](const drawing::RayStyle& style) {
            return style.emphasis != drawing::Emphasis::path &&
                   weight(trace_->rays[std::size_t(style.ray)]) < least_weight_;
        });
        if (styles_.size() > most_rays_drawn) styles_.resize(most_rays_drawn);
        draw_strokes();
        drawing::aim(actors_->world->GetActiveCamera(), *view_);
        actors_->clip(*view_, orbit_.radius, scene_->region.radius);
    }
    render(false);
    refine_timer_.start(refine_after);
}

/// Without a graphics card the right order of all that is translucent takes several times as long: it waits for a rest.
void RayView::render(bool fine) {
    actors_->draw_finely(fine);
    if (isValid()) actors_->window->Render();
    update();
}

/// While one turns the camera everything keeps its shape; strokes, labels and silhouettes follow when it rests.
void RayView::aim() {
    if (!view_) return;
    const drawing::View now = orbit_.view(area());
    const double scale = orbit_.radius / view_->scale();
    const Vec3d position = view_->to_view(orbit_.pivot) + now.position() * scale;
    actors_->look(position, position - now.back(), now.up());
    actors_->show_labels(false);
}

void RayView::draw_surfaces() {
    drawing::Surfaces shown;
    for (const drawing::Surface& surface : scene_->surfaces.shown) {
        const Presence presence = presence_of(surface.drawn);
        if (presence == Presence::hidden) continue;
        drawing::Surface copy = surface;
        if (presence == Presence::ghost || exploded_.contains(surface.drawn)) copy.hit = false;
        if (presence == Presence::ghost) copy.large = true;
        shown.shown.push_back(std::move(copy));
    }
    for (const drawing::Surface& operand : scene_->operands) shown.shown.push_back(operand);
    actors_->show_surfaces(drawing::paint_surfaces(shown, scene_->bench->scene, *view_));
    actors_->named = std::move(shown);
}

std::vector<std::string> RayView::surfaces_shown() const {
    std::vector<std::string> names;
    for (const drawing::Surface& surface : actors_->named.shown) names.push_back(surface.name);
    return names;
}

void RayView::resizeGL(int width, int height) {
    QVTKOpenGLNativeWidget::resizeGL(width, height);
    changed(true);
}

} // namespace rayscope::window
