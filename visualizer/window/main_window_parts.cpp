// What the window is put together from.

#include "visualizer/window/main_window.hpp"

#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenuBar>
#include <QScrollArea>
#include <QStyle>

#include <algorithm>

namespace rayscope::window {
namespace {

void dock_of(MainWindow& window, const QString& title, QWidget* widget, Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName("dock_" + widget->objectName());
    dock->setWidget(widget);
    window.addDockWidget(area, dock);
}

void make_reader(QPlainTextEdit& view, const char* name) {
    view.setObjectName(name);
    view.setAccessibleName(name);
    view.setReadOnly(true);
    view.setFont(fixed_font());
    view.setLineWrapMode(QPlainTextEdit::NoWrap);
    view.setUndoRedoEnabled(false);
}

} // namespace

void MainWindow::make_docks() {
    setCentralWidget(&space);
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    make_reader(details, "details");
    make_reader(octree.words, "search");
    make_reader(colours, "colours");
    tabs.setObjectName("tabs");
    tabs.setDocumentMode(true);
    tabs.setUsesScrollButtons(true);
    tabs.addTab(&details, "Ray");
    tabs.addTab(&card, "Refraction");
    tabs.addTab(&colours, "Colour");
    tabs.addTab(&octree, "Octree");
    tabs.addTab(&materials, "Materials");
    tabs.addTab(&objects, "Objects");
    tabs.addTab(&console, "Console");
    dock_of(*this, "Image", &image, Qt::LeftDockWidgetArea);
    dock_of(*this, "Recursion tree", &tree, Qt::LeftDockWidgetArea);
    dock_of(*this, "Inside intervals along the ray", &lanes, Qt::BottomDockWidgetArea);
    dock_of(*this, "Details", &tabs, Qt::RightDockWidgetArea);
}

/// As wide as the window lets them be, with most of it for the rays.
void MainWindow::size_docks() {
    const auto dock = [this](const char* name) { return findChild<QDockWidget*>(QString("dock_") + name); };
    const int details_width = width() < 1400 ? 450 : 570;
    resizeDocks({dock("image"), dock("tabs")}, {width() < 1400 ? 310 : 370, details_width}, Qt::Horizontal);
    resizeDocks({dock("image"), dock("tree")}, {height() * 34 / 100, height() * 56 / 100}, Qt::Vertical);
    resizeDocks({dock("lanes")}, {height() * 23 / 100}, Qt::Vertical);
}

QAction* MainWindow::add_action(QMenu* menu, const QString& text, const QString& shortcut, const QString& tip,
                                std::function<void()> act) {
    auto* action = new QAction(text, this);
    if (!shortcut.isEmpty()) action->setShortcut(QKeySequence(shortcut));
    action->setToolTip(tip + (shortcut.isEmpty() ? "" : "  [" + shortcut + "]"));
    action->setStatusTip({});
    action->setData(tip);
    QObject::connect(action, &QAction::triggered, this, std::move(act));
    menu->addAction(action);
    addAction(action);
    return action;
}

void MainWindow::make_menus() {
    QMenu* file = menuBar()->addMenu("&File");
    add_action(file, "&Open …", "Ctrl+O", "another scene", [this] { ask_for_scene(); });
    add_action(file, "&Save", "Ctrl+S", "the changed numbers into the scene's file", [this] { save(); });
    add_action(file, "&Quit", "Ctrl+Q", "end", [this] { close(); });

    QMenu* edit = menuBar()->addMenu("&Edit");
    undo_ = add_action(edit, "&Undo", "Ctrl+Z", "the last change of the scene, or drag of the ray",
                       [this] { undo(); });
    redo_ = add_action(edit, "&Redo", "Ctrl+Shift+Z", "the change that was taken back", [this] { redo(); });

    QMenu* walk = menuBar()->addMenu("&Walk");
    const auto move = [&](const char* text, const char* key, const char* line, const char* tip) {
        add_action(walk, text, key, tip, [this, line] { command(line); })->setObjectName(line);
    };
    move("Step", "S", "step", "the next event");
    move("Step back", "Shift+S", "reverse-step", "the event before");
    move("Next ray", "N", "next", "the start of the next ray");
    move("Ray before", "Shift+N", "back", "the start of the ray before");
    move("In", "I", "in", "into the next ray that this one spawns");
    move("Back into", "Shift+I", "reverse-in", "into the ray that it spawned before, at its end");
    move("Over", "O", "over", "past what this ray spawns");
    move("Back over", "Shift+O", "reverse-over", "the same backwards");
    move("Out", "U", "out", "up, to where the parent goes on");
    move("Back out", "Shift+U", "reverse-out", "back to where the parent spawned this ray");
    move("Continue", "C", "continue", "to the next stop");
    move("Continue back", "Shift+C", "reverse-continue", "to the stop before");
    move("Start", "Home", "goto start", "the first event");
    move("End", "End", "goto end", "the last event");
    move("Undo the move", "Backspace", "undo", "where you were before");
    play_ = add_action(walk, "Play", "Space", "step by step, at the speed beside it",
                       [this] { play(!playing()); });
    play_->setObjectName("play");
    add_action(walk, "Go to …", "G", "a ray N, or its event N.E", [this] {
        show_tab("Console");
        console.begin("goto ");
    });
    add_action(walk, "Stop where …", "B", "a condition, such as tir && depth >= 3", [this] {
        stop_.setFocus();
        stop_.selectAll();
    });
    add_action(walk, "Find pixels where …", "Ctrl+F",
               "pixels whose rays meet a condition, at first that of the last stop", [this] {
                   const auto& stops = desk.walk().stops().all();
                   show_tab("Console");
                   console.begin("find " + (stops.empty()
                                                ? QString()
                                                : QString::fromStdString(stops.back().expression.text())));
               });
    add_action(walk, "Console", ":", "every command of the terminal", [this] {
        show_tab("Console");
        console.begin("");
    });

    QMenu* camera = menuBar()->addMenu("&Camera");
    add_action(camera, "Fit", "F", "all of the trace", [this] { space.fit(); });
    add_action(camera, "Along the ray", "A", "look where the ray goes", [this] { space.look_along_ray(); });
    add_action(camera, "From the eye", "E", "look from where the image is seen",
               [this] { space.look_from_eye(); });
    QAction* lock = add_action(camera, "Lock to the ray", "L", "the camera follows the current ray", [] {});
    lock->setCheckable(true);
    QObject::connect(lock, &QAction::toggled, this, [this](bool on) { space.set_locked(on); });
    add_action(camera, "Nearer", "+", "zoom in", [this] { space.zoom(0.8); });
    add_action(camera, "Farther", "-", "zoom out", [this] { space.zoom(1.25); });
    add_action(camera, "Turn left", "Ctrl+Left", "turn the camera", [this] { space.turn(30, 0); });
    add_action(camera, "Turn right", "Ctrl+Right", "turn the camera", [this] { space.turn(-30, 0); });
    add_action(camera, "Turn up", "Ctrl+Up", "turn the camera", [this] { space.turn(0, 30); });
    add_action(camera, "Turn down", "Ctrl+Down", "turn the camera", [this] { space.turn(0, -30); });

    QMenu* view = menuBar()->addMenu("&View");
    const auto pixel = [&](const char* text, const char* key, int dx, int dy) {
        add_action(view, text, key, "the pixel beside it", [this, dx, dy] {
            const TraceSource& at = desk.trace().source;
            const Camera& c = desk.scene().camera;
            const QPoint next(std::clamp(at.x + dx, 0, c.width - 1), std::clamp(at.y + dy, 0, c.height - 1));
            if (!at.by_hand) image.on_pick(next.x(), next.y());
        });
    };
    pixel("Pixel left", "Alt+Left", -1, 0);
    pixel("Pixel right", "Alt+Right", 1, 0);
    pixel("Pixel up", "Alt+Up", 0, -1);
    pixel("Pixel down", "Alt+Down", 0, 1);
    add_action(view, "Whole image", "W", "no zoom in the image", [this] { image.fit(); });
    add_action(view, "Whole ray", "T", "no zoom in the intervals", [this] {
        lanes.fit();
        lanes.set_sweep(std::nullopt);
    });
    for (int i = 0; i < tabs.count(); ++i) {
        const QString name = tabs.tabText(i);
        add_action(view, name, QString::number(i + 1), "the panel " + name, [this, name] { show_tab(name); });
    }
    add_action(view, "Explode", "X", "the chosen object into its operands", [this] { objects.explode(); });
    add_action(view, "Heat map", "H", "the next overlay of the image",
               [this] { choose_heat((overlay_.currentIndex() + 1) % overlay_.count()); });
    for (QDockWidget* dock : findChildren<QDockWidget*>()) view->addAction(dock->toggleViewAction());

    QMenu* help = menuBar()->addMenu("&Help");
    add_action(help, "First steps", "F1", "how to find your way", [this] { show_first_steps(); });
    add_action(help, "Keys", "?", "this list", [this] { show_cheat_sheet(); });
}

void MainWindow::show_tab(const QString& name) {
    for (int i = 0; i < tabs.count(); ++i)
        if (tabs.tabText(i) == name) tabs.setCurrentIndex(i);
}

bool MainWindow::press(const QString& shortcut) {
    const QKeySequence keys(shortcut);
    for (QAction* action : actions())
        if (!keys.isEmpty() && action->shortcut() == keys && action->isEnabled()) {
            action->trigger();
            return true;
        }
    return false;
}

void MainWindow::ask_for_scene() {
    const QString file = QFileDialog::getOpenFileName(
        this, "Open a scene", QString::fromStdString(desk.file().parent_path().string()),
        "Scenes (*.toml *.nff *.obj *.ply);;All files (*)");
    if (!file.isEmpty()) open_scene(file);
}

} // namespace rayscope::window
