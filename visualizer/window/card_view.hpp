#pragma once
// The refraction card, drawn: the boundary, the rays at their true angles, and all numbers of both sides.

#include "core/rayscope.hpp"

#include <QWidget>

namespace rayscope::window {

class CardView : public QWidget {
public:
    CardView();
    void show_ray(const Trace& trace, int ray);

    /// The lines of the card, for tests too.
    struct Line {
        QString name, value;
    };
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }
    [[nodiscard]] QSize sizeHint() const override { return {320, 420}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void draw_angles(QPainter& painter, const QRectF& area) const;

    std::optional<RefractionCard> card_;
    std::vector<Line> lines_;
    QString from_, to_, nothing_;
    bool reflects_ = false, refracts_ = false;
};

} // namespace rayscope::window
