#pragma once
// The objects of the scene: shown, as a ghost, or hidden; alone; or taken apart into their operands.

#include "visualizer/window/ray_view.hpp"

#include <QTreeWidget>
#include <QWidget>

namespace rayscope::window {

class ObjectPanel : public QWidget {
public:
    /// @param view what it shows and hides; must outlive the panel
    explicit ObjectPanel(RayView& view);

    void show_scene(const Scene& scene);
    void mark(std::size_t drawn); ///< the object that the current ray ends on
    /// By name; false: there is no such object in the list.
    [[nodiscard]] bool choose(const std::string& name);
    void set_presence(Presence presence);
    void isolate();
    void explode();
    void show_all();

private:
    [[nodiscard]] std::optional<std::size_t> chosen() const;
    void refresh();

    RayView& view_;
    QTreeWidget list_;
    std::size_t objects_ = 0;
};

} // namespace rayscope::window
