// The mouse in the 3D view.

#include "visualizer/window/ray_view_parts.hpp"

#include <QMouseEvent>

#include <cmath>

namespace rayscope::window {

/// VTK's own interaction stays out: its keys and buttons mean other things.
bool RayView::event(QEvent* event) {
    if (event->type() == draw_event) {
        if (draw_posted_) draw();
        return true;
    }
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
    caught_.reset();
    if (event->button() == Qt::LeftButton && bench_ && view_)
        catch_handle(pressed_, event->modifiers() & Qt::ControlModifier);
}

void RayView::mouseMoveEvent(QMouseEvent* event) {
    if (!view_) return;
    if (event->buttons() == Qt::NoButton) {
        if (handle_at(event->localPos()))
            setCursor(Qt::SizeAllCursor);
        else
            unsetCursor();
        return;
    }
    const QPointF moved = event->localPos() - last_;
    last_ = event->localPos();
    if (caught_ && (event->buttons() & Qt::LeftButton)) {
        if (caught_moved_ || !is_click(event->localPos())) drag_handle(event->localPos() - pressed_);
        return;
    }
    if (event->buttons() & Qt::LeftButton)
        orbit_.turn(moved.x(), moved.y());
    else
        orbit_.shift(orbit_.view(area()), moved.x(), moved.y());
    keep_moving();
}

/// The mouse has not left the place where it was pressed.
bool RayView::is_click(QPointF at) const {
    constexpr double still = 4; // pixels
    return std::hypot(at.x() - pressed_.x(), at.y() - pressed_.y()) < still;
}

void RayView::keep_moving() {
    moving_ = true;
    settle_timer_.start(160);
    changed(false);
}

void RayView::mouseReleaseEvent(QMouseEvent* event) {
    const bool clicked = is_click(event->localPos()) && !caught_moved_ && event->button() == Qt::LeftButton;
    const bool chooses = event->modifiers() & Qt::ControlModifier;
    caught_.reset();
    caught_moved_ = false;
    if (moving_) {
        settle_timer_.stop();
        moving_ = false;
        changed(true);
    }
    if (!clicked || !view_ || chooses) return;
    if (const int ray = ray_at(event->localPos()); ray != none && on_ray) on_ray(ray);
}

void RayView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { fit(); }

void RayView::wheelEvent(QWheelEvent* event) {
    orbit_.zoom(std::pow(0.9988, event->angleDelta().y()));
    keep_moving();
}

} // namespace rayscope::window
