// What changes the scene or the ray, and takes it back.

#include "visualizer/window/main_window.hpp"

namespace rayscope::window {

void MainWindow::link_changes() {
    space.on_drag = [this](const Handle& handle, const Vec3d& to, double pixel, bool continues) {
        change([&] { dragged(handle, to, pixel, continues); });
    };
    space.on_grip = [this](const std::optional<Grip>& grip) {
        if (grip) objects.mark_grip(*grip);
    };
    materials.on_change = [this](std::size_t material, MaterialPart part, double value, bool continues) {
        change([&] { desk.set_material(material, part, value, continues); });
    };
}

void MainWindow::change(const std::function<void()>& how) {
    if (is_asked()) return;
    try {
        how();
    } catch (const std::exception& error) {
        say(error.what(), true);
    }
}

void MainWindow::dragged(const Handle& handle, const Vec3d& to, double pixel, bool continues) {
    switch (handle.kind) {
    case Handle::Kind::light: desk.move_light(handle.index, to, pixel, continues); break;
    case Handle::Kind::generic: desk.move_generic(*space.grip(), to, pixel, continues); break;
    case Handle::Kind::ray_start: desk.move_ray(handle.moved(to), handle.other, pixel, continues); break;
    case Handle::Kind::ray_end: desk.move_ray(handle.other, to, pixel, continues); break;
    }
}

void MainWindow::save() {
    try {
        if (!desk.changed()) return say("Nothing was changed");
        desk.save();
        say("Saved " + QString::fromStdString(desk.file().string()));
    } catch (const std::exception& error) {
        say(error.what(), true);
    }
    show_title();
}

void MainWindow::undo() {
    change([this] {
        if (!desk.undo()) say("Nothing was changed before");
    });
}

void MainWindow::redo() {
    change([this] {
        if (!desk.redo()) say("Nothing was taken back");
    });
}

} // namespace rayscope::window
