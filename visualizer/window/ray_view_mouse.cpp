// The mouse in the 3D view.

#include "visualizer/window/ray_view_parts.hpp"

#include <QMouseEvent>

#include <cmath>

namespace rayscope::window {

/// VTK's own interaction stays out: its keys and buttons mean other things.
bool RayView::event(QEvent* event) {
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
    case QEvent::Enter:
    case QEvent::Leave: return QOpenGLWidget::event(event);
    default: return QVTKOpenGLNativeWidget::event(event);
    }
}

void RayView::mousePressEvent(QMouseEvent* event) {
    setFocus();
    pressed_ = last_ = event->localPos();
    dragged_light_.reset();
    light_moved_ = false;
    if (event->button() != Qt::LeftButton || !bench_ || !view_) return;
    constexpr double reach = 12; // pixels
    for (std::size_t i = 0; i < bench_->scene.lights.size(); ++i)
        if (const auto place = place_of_light(i);
            place && std::hypot(place->x() - pressed_.x(), place->y() - pressed_.y()) < reach)
            dragged_light_ = i;
}

void RayView::mouseMoveEvent(QMouseEvent* event) {
    if (!view_ || event->buttons() == Qt::NoButton) return;
    const QPointF moved = event->localPos() - last_;
    last_ = event->localPos();
    if (dragged_light_ && (event->buttons() & Qt::LeftButton)) {
        // In the plane through it that faces the camera.
        const Vec3d at = bench_->scene.lights[*dragged_light_].position;
        const double pixel = view_->pixel_size(view_->to_view(at)) * view_->scale();
        const Vec3d next = at + (view_->right() * moved.x() - view_->up() * moved.y()) * pixel;
        if (on_light) on_light(*dragged_light_, next, light_moved_);
        light_moved_ = true;
        return;
    }
    if (event->buttons() & Qt::LeftButton)
        orbit_.turn(moved.x(), moved.y());
    else
        orbit_.shift(orbit_.view(area()), moved.x(), moved.y());
    keep_moving();
}

void RayView::keep_moving() {
    moving_ = true;
    settle_timer_.start(160);
    changed(false);
}

void RayView::mouseReleaseEvent(QMouseEvent* event) {
    constexpr double still = 4; // pixels
    const QPointF moved = event->localPos() - pressed_;
    const bool clicked = std::hypot(moved.x(), moved.y()) < still && event->button() == Qt::LeftButton;
    if (moving_) {
        settle_timer_.stop();
        moving_ = false;
        changed(true);
    }
    if (!clicked || !view_ || dragged_light_) return;
    if (const int ray = ray_at(event->localPos()); ray != none && on_ray) on_ray(ray);
}

void RayView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { fit(); }

void RayView::wheelEvent(QWheelEvent* event) {
    orbit_.zoom(std::pow(0.9988, event->angleDelta().y()));
    keep_moving();
}

} // namespace rayscope::window
