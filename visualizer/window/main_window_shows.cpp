// What the views show of the walk.

#include "visualizer/cli/event_text.hpp"
#include "visualizer/drawing/scene_objects.hpp"
#include "visualizer/window/known_part.hpp"
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

const QString hidden = "Hidden while a question is open: answer it in the console.";

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
    known_.reset();
    if (!desk.session().found()) forget_found();
    if (desk.session().quizzing()) known_ = known_part(desk.walk());
    const Trace& trace = shown();
    space.show_trace(desk.bench(), trace, desk.ray(), frame_next_);
    tree.show_trace(&trace, least_weight());
    octree_run_.begin(desk.bench(), desk.trace());
    showing_ = true;
    moments.setRange(0, int(desk.walk().timeline().size()) - 1);
    showing_ = false;
    undo_->setEnabled(desk.can_undo());
    redo_->setEnabled(desk.can_redo());
    set_text(colours, known_ ? hidden
                             : QString::fromStdString(cli::result_text(trace, desk.style()) + "\n" +
                                                      cli::ledger_text(trace, desk.style())));
    show_pixel();
    show_stops();
    moved();
}

void MainWindow::moved() {
    const int ray = desk.ray();
    const Trace& trace = shown();
    tree.show_ray(ray);
    space.show_ray(ray);
    lanes.show_ray(trace, ray);
    card.show_ray(trace, ray);
    const Event& here = desk.here().happened();
    if (const auto t = t_of(here); t && std::isfinite(*t)) lanes.set_sweep(t);
    showing_ = true;
    moments.setValue(int(desk.walk().cursor().moment()));
    showing_ = false;
    show_objects();
    show_texts();
    show_octree();
    show_title();
}

/// The panels about things follow the ray to what it hits.
void MainWindow::show_objects() {
    const Trace& trace = shown();
    const auto* hit = trace.rays[std::size_t(desk.ray())].find<BoundaryChosen>();
    if (hit == nullptr) {
        // What was marked before may be the answer.
        if (known_) objects.mark(std::nullopt);
        if (known_) materials.choose(0);
        return;
    }
    const std::vector<Id> drawn =
        desk.scene().drawn.size() < 2000 ? drawing::drawn_objects(trace, desk.scene()) : std::vector<Id>{};
    if (std::size_t(hit->object) >= drawn.size() || drawn[std::size_t(hit->object)] == none) return;
    const auto id = std::size_t(drawn[std::size_t(hit->object)]);
    objects.mark(id);
    const SceneObject& object = desk.scene().drawn[id];
    const auto& material = object.is_compound ? desk.scene().compounds[object.index].material
                                              : desk.scene().generics[object.index].material;
    if (material && &materials != focusWidget() && !materials.isAncestorOf(focusWidget()))
        materials.choose(*material);
}

/// In the image too the place of the pixel would tell what its ray meets.
void MainWindow::show_pixel() {
    const TraceSource& source = desk.trace().source;
    image.mark(source.by_hand || known_ ? std::nullopt : std::optional(QPoint(source.x, source.y)));
    const QString which =
        source.by_hand ? QString("ray given by hand") : QString("pixel (%1, %2)").arg(source.x).arg(source.y);
    const Colour& c = desk.trace().colour;
    pixel_.setText(known_ ? which + "   " + hidden
                          : which + QString("   colour %1 %2 %3 (linear)   %4, %5 events ")
                                        .arg(c.r, 0, 'g', 4)
                                        .arg(c.g, 0, 'g', 4)
                                        .arg(c.b, 0, 'g', 4)
                                        .arg(QString::fromStdString(
                                            cli::counted(int(desk.trace().rays.size()), "ray", "rays")))
                                        .arg(desk.walk().timeline().size()));
}

void MainWindow::show_texts() {
    std::string text = cli::event_text(desk.here(), desk.style(), true);
    text +=
        known_ ? "\n" + hidden.toStdString() + "\n" : cli::ray_text(desk.trace(), desk.ray(), desk.style());
    const auto begin = text.find_first_not_of('\n');
    set_text(details, QString::fromStdString(begin == std::string::npos ? text : text.substr(begin)));
}

/// Only while it is seen: an octree is built for it.
void MainWindow::show_octree() {
    if (known_) return octree.show_nothing(hidden);
    if (tabs.currentWidget() != &octree) return;
    const Trace& trace = octree_run_.trace();
    const OctreeStatistics& all = octree_run_.statistics();
    cli::Page page(desk.style().paint);
    cli::add_search(page, trace, desk.ray(), desk.style());
    const double held = all.leaves > 0 ? double(all.entries) / double(all.leaves) : 0;
    octree.show_ray(
        trace, desk.ray(), all.depth,
        QString("The whole octree: %1 levels, %2 divided cells, %3 undivided ones with objects in "
                "them, on average %4 each; %5 objects without end, in no cell.")
            .arg(all.depth)
            .arg(all.nodes)
            .arg(all.leaves)
            .arg(held, 0, 'g', 3)
            .arg(all.apart),
        QString::fromStdString(page.text()).trimmed());
}

void MainWindow::show_title() {
    const Spot spot = desk.walk().cursor().spot();
    const auto& rays = desk.trace().rays;
    const RaySpawned& start = rays[std::size_t(spot.ray)].start();
    const auto last = [this](std::size_t count) { return known_ ? "?" : QString::number(count - 1); };
    place_.setText(QString("  ray %1 of 0–%2, %3, depth %4, event %5 of %6: <b>%7</b>  ")
                       .arg(spot.ray)
                       .arg(last(rays.size()))
                       .arg(cli::name_of(start.kind))
                       .arg(start.depth)
                       .arg(spot.event)
                       .arg(last(rays[std::size_t(spot.ray)].events.size()))
                       .arg(QString::fromUtf8(event_name(desk.here().happened()).data()).replace('_', ' ')));
    setWindowTitle(QString::fromStdString(desk.file().stem().string()) +
                   (desk.changed() ? " (changed)" : "") + " – rayscope");
}

} // namespace rayscope::window
