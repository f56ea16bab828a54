#include "visualizer/window/image_view.hpp"

#include "visualizer/drawing/heat_map.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/window/colours.hpp"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rayscope::window {
namespace {

constexpr double most_zoom = 64;
constexpr int most_ringed = 200; // pixels: more are seen without

/// A line of text in the lower left corner, legible on any image, with room for `more` lines beneath.
QRect draw_caption(QPainter& painter, const QString& text, const QRect& within, int width = 0, int more = 0) {
    const QFontMetrics metrics(painter.font());
    const int line = metrics.height(), wide = std::max(metrics.horizontalAdvance(text), width);
    const int high = (1 + more) * line + 6 + 4 * more;
    const QRect box(within.left() + 6, within.bottom() - high - 4, wide + 12, high);
    painter.fillRect(box, QColor(255, 255, 255, 225));
    painter.setPen(qt_colour(drawing::ink));
    painter.drawText(box.adjusted(6, 3, -6, 0), Qt::AlignTop | Qt::AlignLeft, text);
    return box;
}

/// What a heat map's colours mean.
void draw_scale(QPainter& painter, const MadeImage& image, const QRect& within) {
    const QString name = QString::fromUtf8(heat_names[std::size_t(*image.heat)].meaning.data());
    const QString most = QString::fromStdString(drawing::number(image.most, 3));
    const QFontMetrics metrics(painter.font());
    const int line = metrics.height(), bar = 110;
    const int wide = bar + metrics.horizontalAdvance("0" + most) + 16;
    const QRect box = draw_caption(painter, name, within, wide, 1);
    int x = box.left() + 6;
    const int y = box.top() + 5 + line;
    painter.drawText(QRect(x, y, 20, line), Qt::AlignLeft, "0");
    x += metrics.horizontalAdvance("0") + 6;
    for (int i = 0; i < bar; ++i)
        painter.fillRect(x + i, y + 2, 1, line - 4, qt_colour(drawing::heat_colour((i + 0.5) / bar)));
    painter.drawText(QRect(x + bar + 6, y, wide, line), Qt::AlignLeft, most);
}

QImage veil_over(const Map& events) {
    QImage veil(events.width, events.height, QImage::Format_ARGB32_Premultiplied);
    for (int y = 0; y < events.height; ++y)
        for (int x = 0; x < events.width; ++x)
            veil.setPixel(x, y, events.at(x, y) > 0 ? qRgba(0, 0, 0, 0) : qRgba(180, 180, 180, 190));
    return veil;
}

} // namespace

ImageView::ImageView() {
    setObjectName("image");
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setAccessibleName("Image of the scene");
    setToolTip(
        "Click or drag: the ray of that pixel. Arrow keys: the pixel beside it.\nWheel: zoom. Right drag: "
        "move. Double right click: the whole image.");
}

void ImageView::show_image(const MadeImage& image) {
    image_ = image;
    update();
}

void ImageView::mark(std::optional<QPoint> pixel) {
    pixel_ = pixel;
    update();
}

void ImageView::show_found(const std::optional<cli::Found>& found) {
    found_ = found;
    veil_ = found ? veil_over(found->result.events) : QImage();
    ringed_.clear();
    if (found && found->result.pixels <= most_ringed) ringed_ = cli::found_pixels(found->result, most_ringed);
    update();
}

void ImageView::draw_found(QPainter& painter, const QRectF& area) const {
    painter.drawImage(area, veil_);
    const double pixel = area.width() / found_->result.events.width, radius = std::max(pixel, 6.0);
    painter.setPen(QPen(QColor(0xC0, 0x40, 0x00), 1.6));
    for (const cli::FoundPixel& at : ringed_)
        painter.drawEllipse(QPointF(area.left() + (at.x + .5) * pixel, area.top() + (at.y + .5) * pixel),
                            radius, radius);
    draw_caption(painter,
                 QString("%1 %2 found: %3")
                     .arg(found_shown())
                     .arg(found_shown() == 1 ? "pixel" : "pixels")
                     .arg(QString::fromStdString(found_->condition)),
                 rect());
}

void ImageView::fit() {
    zoom_ = 1;
    middle_ = {.5, .5};
    update();
}

QRectF ImageView::area() const {
    const double w = std::max(image_.width, 1), h = std::max(image_.height, 1);
    const double scale = std::min(width() / w, height() / h) * zoom_;
    const QSizeF size(w * scale, h * scale);
    // What fits stands in the middle.
    const double x =
        size.width() <= width() ? (width() - size.width()) / 2 : width() / 2.0 - middle_.x() * size.width();
    const double y = size.height() <= height() ? (height() - size.height()) / 2
                                               : height() / 2.0 - middle_.y() * size.height();
    return {{x, y}, size};
}

QPoint ImageView::place_of(int x, int y) const {
    const QRectF a = area();
    return {int(a.left() + (x + .5) / std::max(image_.width, 1) * a.width()),
            int(a.top() + (y + .5) / std::max(image_.height, 1) * a.height())};
}

void ImageView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0xE4, 0xE7, 0xEC));
    if (image_.picture.isNull()) {
        painter.setPen(qt_colour(drawing::quiet_ink));
        painter.drawText(rect(), Qt::AlignCenter, "The image is being made …");
        return;
    }
    const QRectF a = area();
    const double pixel = a.width() / image_.width;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, pixel < 2);
    painter.drawImage(a, image_.picture);
    if (image_.heat) draw_scale(painter, image_, rect());
    if (found_) draw_found(painter, a);
    if (!pixel_) return;
    const QRectF square(a.left() + pixel_->x() * pixel, a.top() + pixel_->y() * pixel, pixel, pixel);
    const double half = std::max(pixel / 2, 4.0);
    const QRectF mark(square.center() - QPointF(half, half), QSizeF(2 * half, 2 * half));
    // Dark within light: seen on any ground.
    for (const auto& [colour, wide] : {std::pair(QColor(255, 255, 255), 4.0), {QColor(0, 0, 0), 1.6}}) {
        painter.setPen(QPen(colour, wide));
        painter.drawRect(mark);
        const QPointF c = mark.center();
        for (const QPointF d : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
            painter.drawLine(c + d * half, c + d * (half + 9));
    }
}

void ImageView::pick(QPointF at) {
    const QRectF a = area();
    if (image_.width < 1 || !on_pick) return;
    const int x = int(std::floor((at.x() - a.left()) / a.width() * image_.width));
    const int y = int(std::floor((at.y() - a.top()) / a.height() * image_.height));
    const QPoint pixel(std::clamp(x, 0, image_.width - 1), std::clamp(y, 0, image_.height - 1));
    if (pixel != pixel_) on_pick(pixel.x(), pixel.y());
}

void ImageView::mousePressEvent(QMouseEvent* event) {
    dragged_from_ = event->localPos();
    if (event->button() == Qt::LeftButton) pick(event->localPos());
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) pick(event->localPos());
    if (event->buttons() & (Qt::RightButton | Qt::MiddleButton)) {
        const QPointF moved = event->localPos() - dragged_from_;
        const QRectF a = area();
        middle_ -= QPointF(moved.x() / a.width(), moved.y() / a.height());
        middle_ = {std::clamp(middle_.x(), 0., 1.), std::clamp(middle_.y(), 0., 1.)};
        dragged_from_ = event->localPos();
        update();
    }
}

void ImageView::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() == Qt::RightButton) fit();
}

void ImageView::wheelEvent(QWheelEvent* event) {
    const QRectF before = area();
    const QPointF at = event->position();
    const QPointF share((at.x() - before.left()) / before.width(), (at.y() - before.top()) / before.height());
    zoom_ = std::clamp(zoom_ * std::pow(1.0015, event->angleDelta().y()), 1.0, most_zoom);
    const QSizeF size = area().size();
    // The pixel under the pointer stays there.
    middle_ = {share.x() - (at.x() - width() / 2.0) / size.width(),
               share.y() - (at.y() - height() / 2.0) / size.height()};
    middle_ = {std::clamp(middle_.x(), 0., 1.), std::clamp(middle_.y(), 0., 1.)};
    update();
}

void ImageView::keyPressEvent(QKeyEvent* event) {
    QPoint step;
    if (event->key() == Qt::Key_Left) step = {-1, 0};
    if (event->key() == Qt::Key_Right) step = {1, 0};
    if (event->key() == Qt::Key_Up) step = {0, -1};
    if (event->key() == Qt::Key_Down) step = {0, 1};
    if (step.isNull() || !pixel_) return QWidget::keyPressEvent(event);
    if (event->modifiers() & Qt::ShiftModifier) step *= 10;
    const QPoint next(std::clamp(pixel_->x() + step.x(), 0, image_.width - 1),
                      std::clamp(pixel_->y() + step.y(), 0, image_.height - 1));
    if (on_pick && next != pixel_) on_pick(next.x(), next.y());
}

} // namespace rayscope::window
