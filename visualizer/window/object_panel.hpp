#pragma once
// The objects of the scene and the operands that they are made of: shown, as a ghost, or hidden; alone; taken apart.

#include "visualizer/window/ray_view.hpp"

#include <QTreeWidget>
#include <QWidget>

namespace rayscope::window {

class ObjectPanel : public QWidget {
public:
    /// @param view what it shows and hides; must outlive the panel
    explicit ObjectPanel(RayView& view);

    void show_scene(const Scene& scene);
    void mark(std::optional<std::size_t> drawn); ///< the object that the current ray ends on
    void mark_grip(const Grip& grip);
    /// An object or an operand, by name; false: there is none in the list.
    [[nodiscard]] bool choose(const std::string& name);
    void set_presence(Presence presence);
    void isolate();
    void explode();
    void show_all();

private:
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    void refresh();
    void fill(const Scene& scene);
    void add_operands(QTreeWidgetItem& item, const Scene& scene, std::size_t drawn);
    void take_hold(); ///< of the generic in the current row

    RayView& view_;
    QTreeWidget list_;
    std::size_t objects_ = 0;
    std::vector<Grip> grips_; // of the rows that stand for a generic
    bool marking_ = false;    // the current row was not chosen by hand
};

} // namespace rayscope::window
