#include "visualizer/window/octree_panel.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace rayscope::window {

OctreePanel::OctreePanel() {
    setObjectName("octree");
    words.setObjectName("search");
    levels.setOrientation(Qt::Horizontal);
    levels.setObjectName("levels");
    levels.setAccessibleName("Deepest level of the octree that is shown");
    levels.setToolTip("Cells below this level are left out, here and in the 3D view");
    levels.setPageStep(1);
    levels.setTickPosition(QSlider::TicksBelow);
    levels.setFocusPolicy(Qt::ClickFocus);
    about_.setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    saved_.setObjectName("saved");
    saved_.setTextFormat(Qt::RichText);
    column->addWidget(&saved_);
    auto* row = new QHBoxLayout;
    row->addWidget(&level_);
    row->addWidget(&levels, 1);
    column->addLayout(row);
    column->addWidget(&chart, 3);
    column->addWidget(&about_);
    column->addWidget(&words, 1);
    QObject::connect(&levels, &QSlider::valueChanged, this, [this] { show_level(); });
}

void OctreePanel::show_level() {
    level_.setText(QString("Down to level %1 of %2 ").arg(levels.value()).arg(levels.maximum()));
    chart.set_level(levels.value());
    if (on_level) on_level(levels.value());
}

void OctreePanel::show_ray(const Trace& trace, int ray, int depth, const QString& about,
                           const QString& text) {
    const auto facts = octree_facts(trace, ray);
    saved_.setText(facts ? QString("<b>With an octree %1 of %2 objects need no test for this ray.</b>")
                               .arg(facts->saved)
                               .arg(facts->objects)
                         : QString());
    chart.show_facts(facts, "The record of that search was full.");
    if (depth != depth_) { // of another octree all is shown
        depth_ = depth;
        levels.setRange(0, depth);
        levels.setValue(depth);
        show_level();
    }
    about_.setText(about);
    if (words.toPlainText() != text) words.setPlainText(text);
}

void OctreePanel::show_nothing(const QString& why) {
    chart.show_facts(std::nullopt, why);
    saved_.clear();
    about_.clear();
    words.clear();
}

} // namespace rayscope::window
