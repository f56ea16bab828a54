#pragma once
// The window: views of one walk, linked by its cursor.

#include "visualizer/window/card_view.hpp"
#include "visualizer/window/console.hpp"
#include "visualizer/window/desk.hpp"
#include "visualizer/window/image_view.hpp"
#include "visualizer/window/lanes_view.hpp"
#include "visualizer/window/material_panel.hpp"
#include "visualizer/window/object_panel.hpp"
#include "visualizer/window/octree_panel.hpp"
#include "visualizer/window/octree_run.hpp"
#include "visualizer/window/ray_tree.hpp"
#include "visualizer/window/ray_view.hpp"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMainWindow>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

namespace rayscope::window {

class MainWindow : public QMainWindow {
public:
    /// @param remember the layout of the last time, and keep this one's
    MainWindow(Desk& desk, bool remember);

    // What a script drives, and what tests read.
    Desk& desk;
    QTabWidget tabs; // before its pages: what they lie in goes after them
    ImageView image;
    RayTree tree;
    RayView space;
    LanesView lanes;
    CardView card;
    QPlainTextEdit details, colours;
    OctreePanel octree;
    Console console;
    MaterialPanel materials;
    ObjectPanel objects;
    QSlider moments, weights;

    /// As the letter, the menu or the button would. False: the terminal would not know it.
    bool command(const std::string& line);
    void open_scene(const QString& file);
    void save();
    void undo();
    void redo();
    void choose_heat(int index); ///< 0: the image itself, else one of heat_names
    void choose_stage(const std::string& stage);
    void play(bool on);
    [[nodiscard]] bool playing() const { return play_timer_.isActive(); }
    void show_tab(const QString& name);
    /// Carries out what has such a shortcut; false: nothing has.
    bool press(const QString& shortcut);
    [[nodiscard]] QString message() const { return said_.text(); }
    [[nodiscard]] QString place() const { return place_.text(); }
    [[nodiscard]] QString stops() const { return stops_.text(); }
    [[nodiscard]] QString pixel() const { return pixel_.text(); }
    /// The trace; while a question is open, as far as the walk has come.
    [[nodiscard]] const Trace& shown() const { return known_ ? *known_ : desk.trace(); }
    /// Everything that was asked for is on the screen.
    [[nodiscard]] bool complete() const;

protected:
    void closeEvent(QCloseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void make_docks();
    void size_docks();
    void make_menus();
    void make_toolbar();
    void make_options();
    void link();
    void link_changes();
    /// Changes the scene or the ray, unless that can't be now; says why not.
    void change(const std::function<void()>& how);
    void dragged(const Handle& handle, const Vec3d& to, double pixel, bool continues);
    QAction* add_action(QMenu* menu, const QString& text, const QString& shortcut, const QString& tip,
                        std::function<void()> act);
    void say(const QString& text, bool wrong = false);
    void ask_for_scene();
    void show_cheat_sheet();
    void show_first_steps();
    /// A window of its own with a page of text.
    void show_page(const char* name, const QString& title, const QString& text);
    void show_stops();
    void show_found(); ///< as the last of the image's overlays
    void forget_found();
    [[nodiscard]] bool shows_found() const;
    bool may_leave(); ///< changes are saved, or not wanted

    [[nodiscard]] double least_weight() const; ///< of the rays that are shown

    void scene_changed();
    void trace_changed();
    void moved();
    void show_texts();
    void show_octree();
    void show_objects();
    void show_pixel();
    /// Says so if a question is open: until the answer nothing can move or change.
    bool is_asked();
    void show_title();
    void make_image();

    ImageMaker maker_;
    std::optional<Trace> known_; // while a question is open
    OctreeRun octree_run_;
    QLabel place_, pixel_, said_;
    QDoubleSpinBox speed_;
    QLineEdit stop_;
    QToolButton stops_;
    QComboBox overlay_, stage_;
    QAction *undo_ = nullptr, *redo_ = nullptr, *play_ = nullptr;
    QTimer play_timer_, image_timer_;
    bool remember_, frame_next_ = true, typing_ = false, showing_ = false, sized_ = false;
};

} // namespace rayscope::window
