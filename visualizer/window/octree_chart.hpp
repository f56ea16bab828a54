#pragma once
// What a ray did in the octree, drawn: its cells along t, how many on each level, and how full they are.

#include "visualizer/window/octree_facts.hpp"

#include <QWidget>

namespace rayscope::window {

class OctreeChart : public QWidget {
public:
    OctreeChart();
    /// @param nothing what stands there if there are no facts
    void show_facts(std::optional<OctreeFacts> facts, const QString& nothing);
    void set_level(int level); ///< levels below are left out
    [[nodiscard]] const std::optional<OctreeFacts>& facts() const { return facts_; }
    [[nodiscard]] int level() const;

    [[nodiscard]] QSize sizeHint() const override { return {420, 520}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {280, 340}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void draw_counters(QPainter& painter, const QRectF& area) const;
    void draw_along(QPainter& painter, const QRectF& area) const;
    void draw_levels(QPainter& painter, const QRectF& area) const;
    void draw_held(QPainter& painter, const QRectF& area) const;

    std::optional<OctreeFacts> facts_;
    QString nothing_;
    int level_ = 0;
};

} // namespace rayscope::window
