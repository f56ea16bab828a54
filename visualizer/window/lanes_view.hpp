#pragma once
// The inside intervals of the current ray, a lane for each generic and each node of a compound. A sweep line tells
// where along the ray one looks, and how often a point there is inside.

#include "visualizer/drawing/lanes.hpp"
#include "visualizer/drawing/timeline.hpp"

#include <QAbstractScrollArea>

#include <functional>
#include <optional>

namespace rayscope::window {

class LanesView : public QAbstractScrollArea {
public:
    LanesView();

    /// The sweep line was moved; nothing: taken away.
    std::function<void(std::optional<double> t)> on_sweep;

    void show_ray(const Trace& trace, int ray);
    [[nodiscard]] std::optional<double> sweep() const { return sweep_; }
    void set_sweep(std::optional<double> t);
    void fit();

    /// In how many of the shown lanes t lies inside, and of each whether it does.
    struct Inside {
        std::string label;
        bool inside = false;
    };
    [[nodiscard]] std::vector<Inside> inside_at(double t) const;
    [[nodiscard]] const drawing::Lanes& lanes() const { return lanes_; }

    [[nodiscard]] QSize sizeHint() const override { return {420, 190}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {200, 90}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    [[nodiscard]] int row() const;
    [[nodiscard]] int label_width() const;
    [[nodiscard]] QRect bars() const; // of the viewport: where t runs
    [[nodiscard]] double x_of(double t) const;
    [[nodiscard]] double t_of(double x) const;
    void draw_axis(QPainter& painter) const;
    void draw_lane(QPainter& painter, const drawing::Lane& lane, int y) const;
    void draw_lines(QPainter& painter) const;
    void fit_rows();

    drawing::Lanes lanes_;
    drawing::Window window_, whole_;
    std::optional<double> stop_, sweep_;
    QString stop_text_, nothing_;
    QColor stop_colour_;
    QPointF dragged_from_;
};

} // namespace rayscope::window
