// What the views show of the walk.

#include "visualizer/cli/event_text.hpp"
#include "visualizer/drawing/scene_objects.hpp"
#include "visualizer/window/main_window.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::window {
namespace {

/// Where along the ray something happens, if it does at one place.
std::optional<double> t_of(const Event& event) {
    if (const auto* e = std::get_if<ObjectAccepted>(&event)) return e->t;
    if (const auto* e = std::get_if<SpanFound>(&event)) return e->enter.t;
    if (const auto* e = std::get_if<ClusterMerged>(&event)) return e->t_first;
    if (const auto* e = std::get_if<BlockerPassed>(&event)) return e->t;
    if (const auto* e = std::get_if<PlaceEntered>(&event)) return e->t_in;
    return std::nullopt;
}

void set_text(QPlainTextEdit& view, const QString& text) {
    if (view.toPlainText() == text) return;
    view.setPlainText(text);
}

} // namespace

void MainWindow::scene_changed() {
    materials.show_scene(desk.scene());
    objects.show_scene(desk.scene());
    trace_changed();
    if (frame_next_) image.fit();
    if (frame_next_)
        make_image();
    else
        image_timer_.start(30);
    frame_next_ = false;
}

void MainWindow::trace_changed() {
    const Trace& trace = desk.trace();
    space.show_trace(desk.bench(), trace, desk.ray(), frame_next_);
    tree.show_trace(&trace, least_weight());
    showing_ = true;
    moments.setRange(0, int(desk.walk().timeline().size()) - 1);
    showing_ = false;
    image.mark(trace.source.by_hand ? std::nullopt : std::optional(QPoint(trace.source.x, trace.source.y)));
    const auto& c = trace.colour;
    pixel_.setText((trace.source.by_hand
                        ? QString("ray given by hand")
                        : QString("pixel (%1, %2)").arg(trace.source.x).arg(trace.source.y)) +
                   QString("   colour %1 %2 %3 (linear)   %4 rays, %5 events ")
                       .arg(c.r, 0, 'g', 4)
                       .arg(c.g, 0, 'g', 4)
                       .arg(c.b, 0, 'g', 4)
                       .arg(trace.rays.size())
                       .arg(desk.walk().timeline().size()));
    undo_->setEnabled(desk.can_undo());
    redo_->setEnabled(desk.can_redo());
    set_text(colours, QString::fromStdString(cli::result_text(trace, desk.style())));
    moved();
}

void MainWindow::moved() {
    const int ray = desk.ray();
    const Trace& trace = desk.trace();
    tree.show_ray(ray);
    space.show_ray(ray);
    lanes.show_ray(trace, ray);
    card.show_ray(trace, ray);
    const Event& here = desk.here().happened();
    if (const auto t = t_of(here); t && std::isfinite(*t)) lanes.set_sweep(t);
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    if (const auto* hit = traced.find<BoundaryChosen>()) {
        // The panels about things follow the ray to what it hits.
        const std::vector<Id> drawn = desk.scene().drawn.size() < 2000
                                          ? drawing::drawn_objects(trace, desk.scene())
                                          : std::vector<Id>{};
        if (std::size_t(hit->object) < drawn.size() && drawn[std::size_t(hit->object)] != none) {
            const auto id = std::size_t(drawn[std::size_t(hit->object)]);
            objects.mark(id);
            const SceneObject& object = desk.scene().drawn[id];
            const auto& material = object.is_compound ? desk.scene().compounds[object.index].material
                                                      : desk.scene().generics[object.index].material;
            if (material && &materials != focusWidget() && !materials.isAncestorOf(focusWidget()))
                materials.choose(*material);
        }
    }
    showing_ = true;
    moments.setValue(int(desk.walk().cursor().moment()));
    showing_ = false;
    show_texts();
    show_search();
    show_title();
}

void MainWindow::show_texts() {
    std::string text = cli::event_text(desk.here(), desk.style(), true);
    text += cli::ray_text(desk.trace(), desk.ray(), desk.style());
    const auto begin = text.find_first_not_of('\n');
    set_text(details, QString::fromStdString(begin == std::string::npos ? text : text.substr(begin)));
}

/// Only while it is seen: a stage is built for it.
void MainWindow::show_search() {
    if (tabs.currentWidget() != &search || desk.session().quizzing()) return;
    set_text(search, QString::fromStdString(desk.look("cells octree")));
}

void MainWindow::show_title() {
    const Spot spot = desk.walk().cursor().spot();
    const std::size_t events = desk.trace().rays[std::size_t(spot.ray)].events.size();
    const RaySpawned& start = desk.trace().rays[std::size_t(spot.ray)].start();
    place_.setText(QString("  ray %1 of 0–%2, %3, depth %4, event %5 of %6: <b>%7</b>  ")
                       .arg(spot.ray)
                       .arg(desk.trace().rays.size() - 1)
                       .arg(cli::name_of(start.kind))
                       .arg(start.depth)
                       .arg(spot.event)
                       .arg(events - 1)
                       .arg(QString::fromUtf8(event_name(desk.here().happened()).data()).replace('_', ' ')));
    setWindowTitle(QString::fromStdString(desk.file().stem().string()) +
                   (desk.changed() ? " (changed)" : "") + " – rayscope");
}

} // namespace rayscope::window
