#pragma once
// The scene's image: a click or a drag picks the pixel whose ray is walked through.

#include "visualizer/cli/find_text.hpp"
#include "visualizer/cli/session.hpp"
#include "visualizer/window/image_maker.hpp"

#include <QWidget>

namespace rayscope::window {

class ImageView : public QWidget {
public:
    ImageView();

    std::function<void(int x, int y)> on_pick;

    void show_image(const MadeImage& image);
    /// The pixel whose ray is shown; none for a ray given by hand.
    void mark(std::optional<QPoint> pixel);
    /// All other pixels are veiled, and few found ones are ringed.
    void show_found(const std::optional<cli::Found>& found);
    [[nodiscard]] int found_shown() const { return found_ ? found_->result.pixels : 0; }
    /// A new scene: the whole image.
    void fit();
    [[nodiscard]] bool complete() const { return image_.fine; }
    [[nodiscard]] const MadeImage& image() const { return image_; }
    /// Where a pixel's middle is in this widget.
    [[nodiscard]] QPoint place_of(int x, int y) const;

    [[nodiscard]] QSize sizeHint() const override { return {360, 290}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {160, 120}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] QRectF area() const; // of the image in the widget
    void draw_found(QPainter& painter, const QRectF& area) const;
    void pick(QPointF at);

    MadeImage image_;
    std::optional<cli::Found> found_;
    QImage veil_;                         // over what was not found
    std::vector<cli::FoundPixel> ringed_; // where it is little
    std::optional<QPoint> pixel_;
    double zoom_ = 1;        // 1: the whole image fits
    QPointF middle_{.5, .5}; // of the widget, as shares of the image
    QPointF dragged_from_;
};

} // namespace rayscope::window
