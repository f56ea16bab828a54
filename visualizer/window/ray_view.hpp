#pragma once
// The trace in space: surfaces, rays and marks as in the pictures, with a camera that a person moves.

#include "visualizer/drawing/ray_strokes.hpp"
#include "visualizer/drawing/surfaces.hpp"
#include "visualizer/window/grip.hpp"
#include "visualizer/window/handle.hpp"
#include "visualizer/window/orbit.hpp"
#include "visualizer/window/worker.hpp"

#include <QEvent>
#include <QTimer>
#include <QVTKOpenGLNativeWidget.h>

#include <functional>
#include <map>
#include <memory>
#include <set>

class vtkActor;
class vtkRenderer;

namespace rayscope::drawing {
class CanvasItem;
class LabelPlacer;
struct Canvas;
} // namespace rayscope::drawing

namespace rayscope::window {

/// How an object is shown.
enum class Presence : std::uint8_t { shown, ghost, hidden };

class RayView : public QVTKOpenGLNativeWidget {
public:
    RayView();
    ~RayView() override;

    std::function<void(int ray)> on_ray; ///< a ray was clicked
    /// A handle, as it was when it was caught, is dragged. @param pixel world length of a pixel there: what is less
    /// nobody can aim at. @param continues the same drag goes on
    std::function<void(const Handle& handle, const Vec3d& to, double pixel, bool continues)> on_drag;
    std::function<void(const std::optional<Grip>&)> on_grip; ///< another generic was chosen here

    /// @param frame the camera goes where all of the trace is seen
    void show_trace(std::shared_ptr<const Workbench> bench, const Trace& trace, int ray, bool frame);
    void show_ray(int ray);
    void set_sweep(std::optional<double> t);
    void set_least_weight(double weight);
    void set_deepest_cell(int level); ///< cells of a stage below it are not drawn
    void set_presence(std::map<std::size_t, Presence> presence);
    [[nodiscard]] const std::map<std::size_t, Presence>& presence() const { return presence_; }
    [[nodiscard]] Presence presence_of(std::size_t drawn) const {
        const auto found = presence_.find(drawn);
        return found == presence_.end() ? Presence::shown : found->second;
    }
    void set_exploded(std::set<std::size_t> drawn);
    [[nodiscard]] const std::set<std::size_t>& exploded() const { return exploded_; }

    // The camera.
    void fit();
    void look_along_ray();
    void look_from_eye();
    void set_locked(bool locked);
    void turn(double dx, double dy);
    void zoom(double factor);

    /// Whether the surfaces are those of the trace.
    [[nodiscard]] bool complete() const {
        return !worker_.busy() && scene_ != nullptr && !draw_posted_ && !settle_timer_.isActive() &&
               !refine_timer_.isActive();
    }
    [[nodiscard]] std::size_t rays_drawn() const { return styles_.size(); }
    [[nodiscard]] std::vector<std::string> surfaces_shown() const;
    /// Where the middle of a ray is in the widget, if it is in sight.
    [[nodiscard]] std::optional<QPoint> place_of(int ray) const;
    /// What can be caught now.
    [[nodiscard]] std::vector<Handle> handles() const;
    [[nodiscard]] std::optional<QPointF> place_of(const Handle& handle) const;
    /// The generic that has a handle.
    void set_grip(const std::optional<Grip>& grip);
    [[nodiscard]] const std::optional<Grip>& grip() const { return grip_; }
    /// Draws at once what is waiting to be drawn.
    void finish();

    [[nodiscard]] QSize sizeHint() const override { return {640, 480}; }

protected:
    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeGL(int width, int height) override;

private:
    static constexpr auto draw_event = QEvent::Type(QEvent::User + 1);
    struct Scenery; // what is slow to make: made beside the window
    struct Actors;

    void make_scenery(bool frame);
    void take(std::shared_ptr<const Scenery> scenery, bool frame);
    void changed(bool surfaces); // to be drawn soon
    void draw();
    void render(bool fine);
    void draw_surfaces();
    void draw_strokes();
    void draw_handles(drawing::Canvas& canvas, drawing::LabelPlacer& placer) const;
    void aim();
    void keep_moving(); // the camera moves, and soon rests
    [[nodiscard]] drawing::Area area() const;
    [[nodiscard]] int ray_at(QPointF at) const;
    [[nodiscard]] bool is_click(QPointF at) const;
    [[nodiscard]] std::optional<Handle> handle_at(QPointF at) const;
    void grip_under(QPointF at);
    void catch_handle(QPointF at, bool whole_solid);
    void drag_handle(QPointF by);

    std::shared_ptr<const Workbench> bench_;
    std::shared_ptr<const Trace> trace_;
    std::shared_ptr<const Scenery> scene_;
    std::unique_ptr<Actors> actors_;
    Orbit orbit_;
    std::optional<drawing::View> view_; // in which the actors were made
    std::vector<drawing::RayStyle> styles_;
    std::map<std::size_t, Presence> presence_;
    std::set<std::size_t> exploded_;
    int ray_ = 0;
    std::optional<double> sweep_;
    double least_weight_ = 0;
    int deepest_cell_ = std::numeric_limits<int>::max();
    bool locked_ = false, surfaces_changed_ = false, moving_ = false;
    QPointF pressed_, last_;
    std::optional<Grip> grip_;
    std::optional<Handle> caught_;
    bool caught_moved_ = false;
    bool draw_posted_ = false; // an event to draw is on its way
    QTimer settle_timer_, refine_timer_;
    Worker worker_; // last: it ends before what it hands over to
};

} // namespace rayscope::window
