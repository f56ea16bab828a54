#include "visualizer/window/card_view.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/window/colours.hpp"
#include "visualizer/window/known_part.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rayscope::window {
namespace {

const QColor ink = qt_colour(drawing::ink), quiet = qt_colour(drawing::quiet_ink),
             reflected(0x00, 0x72, 0xB2),
             refracted(0xD5, 0x5E, 0x00), normal = qt_colour(drawing::normal_green),
             critical_grey(0x88, 0x66, 0x99);

QString text(double value, int digits = 5) { return QString::fromStdString(drawing::number(value, digits)); }
QString angle(double radians) { return QString::fromStdString(drawing::degrees(radians)); }

QString share(const Colour& colour) {
    return colour.r == colour.g && colour.g == colour.b
               ? text(colour.r)
               : text(colour.r, 3) + "  " + text(colour.g, 3) + "  " + text(colour.b, 3);
}

void arrow(QPainter& painter, const QPointF& from, const QPointF& to, const QColor& colour, double width) {
    painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(from, to);
    const QPointF middle = (from + to) / 2, d = to - from;
    const double size = std::hypot(d.x(), d.y());
    if (!(size > 1)) return;
    const QPointF u = d / size, v(-u.y(), u.x());
    const QPointF head[] = {middle + u * 8, middle - u * 6 + v * 6, middle - u * 6 - v * 6};
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPolygon(head, 3);
}

} // namespace

CardView::CardView() {
    setObjectName("card");
    setAccessibleName("Refraction card");
    setMinimumSize(220, 300);
}

void CardView::show_ray(const Trace& trace, int ray) {
    card_ = refraction_card(trace, ray);
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    reflects_ = traced.find<Reflected>() != nullptr;
    refracts_ = traced.find<Refracted>() != nullptr;
    lines_.clear();
    nothing_ =
        traced.find<BoundaryChosen>() == nullptr && !is_finished(traced)
            ? "What ray " + QString::number(ray) + " meets is not known yet."
        : traced.find<BoundaryChosen>() == nullptr
            ? "Ray " + QString::number(ray) + " hits no boundary."
            : "Where ray " + QString::number(ray) + " ends, no light goes through: nothing is refracted.";
    if (card_) {
        const RefractionCard& c = *card_;
        from_ = QString::fromStdString(drawing::medium_name(trace, c.medium_from));
        to_ = QString::fromStdString(drawing::medium_name(trace, c.medium_to));
        const auto add = [&](const char* name, const QString& value) {
            lines_.push_back({QString::fromUtf8(name), value});
        };
        add("media", from_ + " → " + to_);
        add("n₁ → n₂", text(1 / c.speed_from) + " → " + text(1 / c.speed_to));
        add("θ₁", angle(c.theta_from));
        add("θ₂", c.theta_to ? angle(*c.theta_to) : "none: total internal reflection");
        add("critical", c.critical ? angle(*c.critical) + (c.total() ? ", passed by " : ", ") +
                                         angle(std::abs(*c.beyond_critical())) + (c.total() ? "" : " away")
                                   : "none: light is slower behind");
        add("Fresnel R",
            text(c.fresnel) + "   (s " + text(c.fresnel_s, 4) + ", p " + text(c.fresnel_p, 4) + ")");
        add("Schlick R", text(c.schlick));
        add("R of the scene", share(c.reflection));
        add("T of the scene", share(c.transmission));
        add("R + T", share(c.reflection + c.transmission));
    }
    update();
}

void CardView::draw_angles(QPainter& painter, const QRectF& area) const {
    const RefractionCard& c = *card_;
    const QPointF middle = area.center();
    const double reach = std::min(area.width() / 2 - 8, area.height() / 2 - 6);
    painter.fillRect(QRectF(area.left(), middle.y(), area.width(), area.height() / 2),
                     QColor(0xDC, 0xE9, 0xF5));
    painter.setPen(QPen(ink, 1.5));
    painter.drawLine(QPointF(area.left(), middle.y()), QPointF(area.right(), middle.y()));
    painter.setPen(QPen(normal, 1.5, Qt::DashLine));
    painter.drawLine(QPointF(middle.x(), area.top() + 2), QPointF(middle.x(), area.bottom() - 2));
    const auto above = [&](double theta, double side) {
        return middle + QPointF(side * std::sin(theta), -std::cos(theta)) * reach;
    };
    if (c.critical) {
        painter.setPen(QPen(critical_grey, 1.5, Qt::DotLine));
        painter.drawLine(middle, above(*c.critical, -1));
    }
    arrow(painter, above(c.theta_from, -1), middle, ink, 3);
    if (reflects_ || c.total()) arrow(painter, middle, above(c.theta_from, 1), reflected, 2.5);
    if (c.theta_to && refracts_) {
        const QPointF end = middle + QPointF(std::sin(*c.theta_to), std::cos(*c.theta_to)) * reach;
        arrow(painter, middle, end, refracted, 2.5);
    }
    const auto label = [&](const QPointF& at, const QString& words, const QColor& colour,
                           Qt::Alignment side) {
        const int wide = painter.fontMetrics().horizontalAdvance(words),
                  high = painter.fontMetrics().height();
        QRectF box(at.x() - (side & Qt::AlignRight ? wide : 0), at.y() - high / 2.0, wide, high);
        box.moveLeft(
            std::clamp(box.left(), area.left() + 2, std::max(area.left() + 2, area.right() - wide - 2)));
        painter.fillRect(box.adjusted(-2, 0, 2, 0), QColor(255, 255, 255, 200));
        painter.setPen(colour);
        painter.drawText(box, Qt::AlignCenter, words);
    };
    const double line = painter.fontMetrics().height();
    label({area.left() + 4, middle.y() - line * 0.8}, from_, quiet, Qt::AlignLeft);
    label({area.left() + 4, middle.y() + line * 0.8}, to_, quiet, Qt::AlignLeft);
    label({area.left() + 4, area.top() + line * 0.7}, "θ₁ " + angle(c.theta_from), ink, Qt::AlignLeft);
    if (c.total()) label({area.right() - 4, area.top() + line * 0.7}, "total", reflected, Qt::AlignRight);
    if (c.theta_to)
        label({area.right() - 4, area.bottom() - line * 0.7}, "θ₂ " + angle(*c.theta_to), refracted,
              Qt::AlignRight);
    if (c.critical)
        label({area.right() - 4, middle.y() - line * 0.8}, "critical " + angle(*c.critical), critical_grey,
              Qt::AlignRight);
}

void CardView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), Qt::white);
    if (!card_) {
        painter.setPen(quiet);
        painter.drawText(rect().adjusted(12, 12, -12, -12), Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap,
                         nothing_);
        return;
    }
    const int line = painter.fontMetrics().height() + 4, table = line * int(lines_.size()) + 10;
    const double drawing_height = std::clamp(double(height() - table - 12), 90.0, width() * 0.8);
    draw_angles(painter, QRectF(8, 6, width() - 16, drawing_height));
    int name_width = 0;
    for (const Line& l : lines_)
        name_width = std::max(name_width, painter.fontMetrics().horizontalAdvance(l.name));
    int y = int(drawing_height) + 12;
    for (const Line& l : lines_) {
        painter.setPen(quiet);
        painter.drawText(QRect(10, y, name_width, line), Qt::AlignLeft | Qt::AlignVCenter, l.name);
        painter.setPen(ink);
        const QRect box(10 + name_width + 14, y, width() - name_width - 32, line);
        painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(l.value, Qt::ElideRight, box.width()));
        y += line;
    }
}

} // namespace rayscope::window
