#include "visualizer/window/lanes_view.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/tessellate.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/window/colours.hpp"
#include "visualizer/window/known_part.hpp"

#include <QMouseEvent>
#include <QPainter>
#include <QScrollBar>

#include <algorithm>
#include <cmath>

namespace rayscope::window {
namespace {

constexpr std::size_t most_lanes_shown = 400;

bool holds(const drawing::Lane& lane, double t) {
    return std::ranges::any_of(lane.spans,
                               [&](const SpanFound& span) { return span.enter.t < t && t < span.exit.t; });
}

} // namespace

LanesView::LanesView() {
    setObjectName("lanes");
    setAccessibleName("Inside intervals along the ray");
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    viewport()->setToolTip(
        "Click or drag: where along the ray to look.\nWheel: zoom. Right drag: move. Double click: "
        "everything, and no sweep line.");
}

void LanesView::show_ray(const Trace& trace, int ray) {
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    lanes_ = drawing::lanes_of(trace, traced, most_lanes_shown);
    window_ = whole_ = drawing::timeline_window(lanes_, traced);
    const drawing::RayEnd end = drawing::drawn_end(traced, 1);
    stop_ = end.open || !std::isfinite(end.t) ? std::nullopt : std::optional(end.t);
    const char* what = traced.find<BoundaryChosen>() != nullptr ? "hit"
                       : drawing::is_blocked(traced)            ? "blocked"
                                                                : "light";
    stop_text_ =
        stop_ ? QString("%1 at t = %2").arg(what, QString::fromStdString(drawing::number(*stop_, 6))) : "";
    stop_colour_ = qt_colour(drawing::ray_text_colour(traced));
    nothing_ = is_finished(traced) ? "The line of ray %1 meets no object."
                                   : "Where the line of ray %1 is inside is not known yet.";
    nothing_ = nothing_.arg(ray);
    sweep_.reset();
    fit_rows();
    viewport()->update();
}

void LanesView::set_sweep(std::optional<double> t) {
    sweep_ = t;
    viewport()->update();
    if (on_sweep) on_sweep(t);
}

void LanesView::fit() {
    window_ = whole_;
    viewport()->update();
}

std::vector<LanesView::Inside> LanesView::inside_at(double t) const {
    std::vector<Inside> answers;
    for (const drawing::Lane& lane : lanes_.shown) answers.push_back({lane.label, holds(lane, t)});
    return answers;
}

int LanesView::row() const { return fontMetrics().height() + 8; }

int LanesView::label_width() const {
    int widest = 40;
    for (const drawing::Lane& lane : lanes_.shown)
        widest = std::max(widest, fontMetrics().horizontalAdvance(QString::fromStdString(lane.label)) + 12);
    return std::min(widest, viewport()->width() * 38 / 100);
}

QRect LanesView::bars() const {
    const int line = fontMetrics().height(), left = label_width() + 12;
    return {left, line + 12, viewport()->width() - left - 24, viewport()->height() - 2 * line - 20};
}

double LanesView::x_of(double t) const {
    const QRect area = bars();
    const double share = (t - window_.low) / (window_.high - window_.low);
    return area.left() + std::clamp(share, -1.0, 2.0) * area.width();
}

double LanesView::t_of(double x) const {
    const QRect area = bars();
    return window_.low + (x - area.left()) / std::max(area.width(), 1) * (window_.high - window_.low);
}

void LanesView::fit_rows() {
    const QRect area = bars();
    const int needed = int(lanes_.shown.size()) * row();
    verticalScrollBar()->setRange(0, std::max(0, needed - area.height()));
    verticalScrollBar()->setPageStep(std::max(area.height(), 1));
    verticalScrollBar()->setSingleStep(row());
}

void LanesView::resizeEvent(QResizeEvent* event) {
    QAbstractScrollArea::resizeEvent(event);
    fit_rows();
}

void LanesView::draw_axis(QPainter& painter) const {
    const QRect area = bars();
    const double span = window_.high - window_.low;
    const double step = drawing::round_size(span * 64 / std::max(area.width(), 1));
    const double largest = std::max(std::abs(window_.low), std::abs(window_.high));
    const int digits = std::clamp(int(std::floor(std::log10(largest / step))) + 2, 3, 15);
    double free = area.left() - 30;
    for (double k = std::ceil(window_.low / step); k * step <= window_.high && step > 0; ++k) {
        const double x = x_of(k * step);
        painter.setPen(qt_colour(drawing::hair));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + 4));
        const QString text = QString::fromStdString(drawing::number(k * step, digits));
        const int wide = fontMetrics().horizontalAdvance(text);
        if (x - wide / 2.0 < free || x + wide / 2.0 > area.right() + 12) continue;
        painter.setPen(qt_colour(drawing::quiet_ink));
        painter.drawText(QPointF(x - wide / 2.0, area.bottom() + 6 + fontMetrics().ascent()), text);
        free = x + wide / 2.0 + 6;
    }
    painter.setPen(qt_colour(drawing::ink));
    painter.drawText(QPointF(area.right() + 14, area.bottom() + 6 + fontMetrics().ascent()), "t");
    if (window_.low < 0 && window_.high > 0) {
        painter.setPen(QPen(qt_colour(drawing::quiet_ink), 1.5));
        painter.drawLine(QPointF(x_of(0), area.top() - 2), QPointF(x_of(0), area.bottom() + 3));
    }
}

void LanesView::draw_lane(QPainter& painter, const drawing::Lane& lane, int y) const {
    const QRect area = bars();
    const int high = row();
    painter.setPen(qt_colour(drawing::hair));
    painter.drawLine(area.left(), y + high / 2, area.right(), y + high / 2);
    for (const SpanFound& span : lane.spans) {
        const double from = std::max(span.enter.t, window_.low), to = std::min(span.exit.t, window_.high);
        if (!(to >= from)) continue;
        const auto bar = [&](double a, double b, drawing::Rgb c) {
            painter.fillRect(QRectF(x_of(a), y + high * 0.2, std::max(x_of(b) - x_of(a), 1.5), high * 0.6),
                             qt_colour(c));
        };
        // What lies behind the start is on the ray's line, not on the ray.
        if (from < 0) bar(from, std::min(to, 0.0), drawing::mixed(lane.colour, drawing::paper, 0.7));
        if (to >= 0) bar(std::max(from, 0.0), to, lane.colour);
        if (span.exit.t > window_.high) {
            const double x = area.right(), tip = high * 0.3;
            const QPointF triangle[] = {{x, y + high * 0.2}, {x + tip, y + high * 0.5}, {x, y + high * 0.8}};
            painter.setPen(Qt::NoPen);
            painter.setBrush(qt_colour(lane.colour));
            painter.drawPolygon(triangle, 3);
        }
    }
    QFont font = painter.font();
    font.setBold(lane.root);
    painter.setFont(font);
    painter.setPen(qt_colour(lane.root ? drawing::ink : drawing::mixed(lane.colour, drawing::ink, 0.6)));
    const bool in = sweep_ && holds(lane, *sweep_);
    const QString mark = sweep_ ? (in ? " ●" : " ○") : "";
    const int room = area.left() - 12;
    const QFontMetrics metrics(font);
    const int mark_width = metrics.horizontalAdvance(mark);
    const QString label =
        metrics.elidedText(QString::fromStdString(lane.label), Qt::ElideMiddle, room - mark_width);
    painter.drawText(QRect(4, y, room, high), Qt::AlignRight | Qt::AlignVCenter, label + mark);
    font.setBold(false);
    painter.setFont(font);
}

void LanesView::draw_lines(QPainter& painter) const {
    const QRect area = bars();
    const int line = fontMetrics().height();
    const auto draw = [&](double t, const QColor& c, Qt::PenStyle style, const QString& text, bool left) {
        if (t < window_.low || t > window_.high) return;
        const double x = x_of(t);
        painter.setPen(QPen(c, 2, style));
        painter.drawLine(QPointF(x, area.top() - 5), QPointF(x, area.bottom() + 3));
        const int wide = fontMetrics().horizontalAdvance(text);
        const double at = std::clamp(left ? x - wide - 6 : x - wide / 2.0, 4.0,
                                     std::max(4.0, viewport()->width() - wide - 4.0));
        painter.setPen(c);
        painter.drawText(QRectF(at, 2, wide + 2, line), Qt::AlignLeft, text);
    };
    if (!sweep_) {
        if (stop_) draw(*stop_, stop_colour_, Qt::SolidLine, stop_text_, false);
        return;
    }
    if (stop_) draw(*stop_, stop_colour_, Qt::SolidLine, "", false);
    const auto count =
        std::ranges::count_if(lanes_.shown, [&](const drawing::Lane& lane) { return holds(lane, *sweep_); });
    draw(*sweep_, qt_colour(drawing::hit_purple), Qt::DashLine,
         QString("t = %1: inside %2 of %3")
             .arg(QString::fromStdString(drawing::number(*sweep_, 6)))
             .arg(count)
             .arg(lanes_.shown.size()),
         false);
}

void LanesView::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(viewport()->rect(), Qt::white);
    if (lanes_.shown.empty()) {
        painter.setPen(qt_colour(drawing::quiet_ink));
        painter.drawText(viewport()->rect().adjusted(12, 12, -12, -12), Qt::AlignTop | Qt::AlignLeft,
                         nothing_);
        return;
    }
    draw_axis(painter);
    const QRect area = bars();
    painter.setClipRect(0, area.top() - 2, viewport()->width(), area.height() + 4);
    const int from = verticalScrollBar()->value();
    for (std::size_t i = 0; i < lanes_.shown.size(); ++i) {
        const int y = area.top() + int(i) * row() - from;
        if (y + row() < area.top() || y > area.bottom()) continue;
        draw_lane(painter, lanes_.shown[i], y);
    }
    painter.setClipping(false);
    draw_lines(painter);
}

void LanesView::mousePressEvent(QMouseEvent* event) {
    dragged_from_ = event->localPos();
    if (event->button() == Qt::LeftButton && !lanes_.shown.empty()) set_sweep(t_of(event->localPos().x()));
}

void LanesView::mouseMoveEvent(QMouseEvent* event) {
    if (lanes_.shown.empty()) return;
    if (event->buttons() & Qt::LeftButton) set_sweep(t_of(event->localPos().x()));
    if (event->buttons() & (Qt::RightButton | Qt::MiddleButton)) {
        const double moved = t_of(dragged_from_.x()) - t_of(event->localPos().x());
        window_ = {window_.low + moved, window_.high + moved};
        dragged_from_ = event->localPos();
        viewport()->update();
    }
}

void LanesView::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
    fit();
    set_sweep(std::nullopt);
}

void LanesView::wheelEvent(QWheelEvent* event) {
    if (event->modifiers() & Qt::ShiftModifier) return QAbstractScrollArea::wheelEvent(event);
    const double t = t_of(event->position().x()), factor = std::pow(0.9985, event->angleDelta().y());
    const double span = (window_.high - window_.low) * factor;
    // Down to what a double can still tell apart.
    if (span < 64 * epsilon<double> * std::max(std::abs(t), 1e-300) ||
        span > 1e6 * (whole_.high - whole_.low))
        return;
    window_ = {t + (window_.low - t) * factor, t + (window_.high - t) * factor};
    viewport()->update();
}

} // namespace rayscope::window
