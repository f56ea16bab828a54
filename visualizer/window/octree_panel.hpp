#pragma once
// The octree as the current ray sees it: a picture down to a level, and the same in words.

#include "visualizer/window/octree_chart.hpp"

#include <QLabel>
#include <QPlainTextEdit>
#include <QSlider>

#include <functional>

namespace rayscope::window {

class OctreePanel : public QWidget {
public:
    OctreePanel();

    std::function<void(int level)> on_level; ///< cells below it are not wanted

    QPlainTextEdit words;
    QSlider levels;
    OctreeChart chart;

    /// @param trace found by an octree, of that depth
    void show_ray(const Trace& trace, int ray, int depth, const QString& about, const QString& text);
    void show_nothing(const QString& why);

private:
    void show_level();

    QLabel saved_, level_, about_;
    int depth_ = -1;
};

} // namespace rayscope::window
