#include "visualizer/window/octree_chart.hpp"

#include "visualizer/drawing/tessellate.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/window/colours.hpp"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rayscope::window {
namespace {

const QColor ink = qt_colour(drawing::ink), quiet = qt_colour(drawing::quiet_ink),
             hair = qt_colour(drawing::hair);
constexpr std::array fates{CellFate::divided, CellFate::tested, CellFate::spared, CellFate::empty};

/// A colour of Okabe and Ito's and a pattern for each.
QBrush brush_of(CellFate fate) {
    switch (fate) {
    case CellFate::divided: return {QColor(0x56, 0xB4, 0xE9), Qt::BDiagPattern};
    case CellFate::tested: return QColor(0x00, 0x72, 0xB2);
    case CellFate::spared: return {QColor(0xB0, 0x6A, 0x00), Qt::Dense5Pattern};
    default: return Qt::white;
    }
}

void fill(QPainter& painter, const QRectF& bar, CellFate fate) {
    painter.fillRect(bar, Qt::white);
    painter.setBrush(brush_of(fate));
    painter.setPen(QPen(ink, 1, fate == CellFate::empty ? Qt::DotLine : Qt::SolidLine));
    painter.drawRect(bar);
    painter.setBrush(Qt::NoBrush);
}

/// Inside a bar, if there is room.
void write_in(QPainter& painter, const QRectF& bar, const QString& text, CellFate fate) {
    const QFontMetrics metrics = painter.fontMetrics();
    const double wide = metrics.horizontalAdvance(text) + 6;
    if (wide > bar.width()) return;
    if (fate != CellFate::tested && fate != CellFate::empty)
        painter.fillRect(QRectF(bar.center().x() - wide / 2, bar.top() + 2, wide, bar.height() - 4),
                         Qt::white);
    painter.setPen(fate == CellFate::tested ? QColor(Qt::white) : ink);
    painter.drawText(bar, Qt::AlignCenter, text);
}

/// A heading, and what is left below it.
QRectF headed(QPainter& painter, QRectF area, const QString& text) {
    const double line = painter.fontMetrics().height();
    QFont font = painter.font();
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft, text);
    font.setBold(false);
    painter.setFont(font);
    area.setTop(area.top() + line + 4);
    return area;
}

QString text(double number, int digits = 4) {
    return QString::fromStdString(drawing::number(number, digits));
}

} // namespace

OctreeChart::OctreeChart() {
    setObjectName("octree_chart");
    setAccessibleName("What the ray did in the octree");
}

void OctreeChart::show_facts(std::optional<OctreeFacts> facts, const QString& nothing) {
    facts_ = std::move(facts);
    nothing_ = nothing;
    update();
}

void OctreeChart::set_level(int level) {
    level_ = level;
    update();
}

int OctreeChart::level() const { return facts_ ? std::min(level_, facts_->deepest) : level_; }

void OctreeChart::draw_counters(QPainter& painter, const QRectF& area) const {
    int visited = 0;
    for (const CellFate fate : {CellFate::divided, CellFate::tested, CellFate::spared})
        visited += facts_->count_to(fate, level());
    std::vector<std::pair<QString, QString>> tiles{{QString::number(visited), "cells visited"}};
    for (const CellFate fate : fates)
        tiles.emplace_back(QString::number(facts_->count_to(fate, level())), fate_names[std::size_t(fate)]);
    tiles.emplace_back(QString("%1 / %2").arg(facts_->tested).arg(facts_->objects), "objects tested");
    const double wide = area.width() / double(tiles.size());
    QFont large = painter.font();
    const QFont small = large;
    large.setPixelSize(18);
    large.setBold(true);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const QRectF tile(area.left() + wide * double(i), area.top(), wide, area.height());
        painter.setPen(ink);
        painter.setFont(large);
        painter.drawText(tile, Qt::AlignHCenter | Qt::AlignTop, tiles[i].first);
        painter.setFont(small);
        painter.setPen(quiet);
        painter.drawText(tile, Qt::AlignHCenter | Qt::AlignBottom, tiles[i].second);
        if (i >= 1 && i <= fates.size())
            fill(painter, QRectF(tile.center().x() - 16, tile.top() + 26, 32, 10), fates[i - 1]);
    }
}

void OctreeChart::draw_along(QPainter& painter, const QRectF& whole) const {
    QRectF area = headed(painter, whole, "Cells along the ray, by level (number: objects tested in it)");
    const double line = painter.fontMetrics().height();
    area.adjust(26, 0, -16, -line - 4);
    double low = infinity<double>, high = 0;
    for (const SeenCell& cell : facts_->cells)
        if (cell.level <= level()) {
            low = std::min(low, cell.t_in);
            high = std::max(high, cell.t_out);
        }
    if (!(high > low)) {
        painter.setPen(quiet);
        painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, "The ray came to no cell.");
        return;
    }
    low = std::max(low, 0.0);
    const double margin = 0.03 * (high - low);
    low -= margin;
    high += margin;
    const auto x_of = [&](double t) { return area.left() + (t - low) / (high - low) * area.width(); };
    const double step = drawing::round_size((high - low) * 70 / area.width());
    for (double k = std::ceil(low / step); k * step <= high; ++k) {
        const double x = x_of(k * step);
        painter.setPen(hair);
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + 3));
        painter.setPen(quiet);
        painter.drawText(QRectF(x - 40, area.bottom() + 4, 80, line), Qt::AlignHCenter, text(k * step));
    }
    painter.drawText(QRectF(area.right() + 4, area.bottom() + 4, 14, line), Qt::AlignLeft, "t");
    const double high_row = area.height() / (level() + 1);
    for (int level = 0; level <= this->level(); ++level) {
        painter.setPen(quiet);
        painter.drawText(QRectF(area.left() - 26, area.top() + high_row * level, 20, high_row),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(level));
    }
    for (const SeenCell& cell : facts_->cells) {
        if (cell.level > level()) continue;
        const double from = x_of(std::max(cell.t_in, low)), to = x_of(cell.t_out);
        const QRectF bar(from, area.top() + high_row * cell.level + high_row * 0.12, std::max(to - from, 2.0),
                         high_row * 0.76);
        fill(painter, bar, cell.fate);
        if (cell.fate != CellFate::divided) write_in(painter, bar, QString::number(cell.tested), cell.fate);
    }
    if (!(facts_->end <= high)) return;
    painter.setPen(QPen(qt_colour(drawing::hit_purple), 2, Qt::DashLine));
    painter.drawLine(QPointF(x_of(facts_->end), area.top() - 2), QPointF(x_of(facts_->end), area.bottom()));
    const QString words = "ends at t = " + text(facts_->end, 6);
    const double wide = painter.fontMetrics().horizontalAdvance(words) + 8;
    const double left = std::min(x_of(facts_->end) + 4, area.right() - wide);
    painter.fillRect(QRectF(left, area.top(), wide, line), QColor(255, 255, 255, 220));
    painter.drawText(QRectF(left, area.top(), wide, line), Qt::AlignCenter, words);
}

void OctreeChart::draw_levels(QPainter& painter, const QRectF& whole) const {
    QRectF area = headed(painter, whole, "Cells on each level");
    area.adjust(26, 0, -46, 0);
    int most = 1;
    const auto all = [&](int level) {
        int number = 0;
        for (const CellFate fate : fates) number += facts_->count(fate, level);
        return number;
    };
    for (int level = 0; level <= this->level(); ++level) most = std::max(most, all(level));
    const double row = std::min(area.height() / (level() + 1), 30.0);
    for (int level = 0; level <= this->level(); ++level) {
        const double y = area.top() + row * level;
        painter.setPen(quiet);
        painter.drawText(QRectF(area.left() - 26, y, 20, row), Qt::AlignRight | Qt::AlignVCenter,
                         QString::number(level));
        double x = area.left();
        for (const CellFate fate : fates) {
            const int number = facts_->count(fate, level);
            if (number == 0) continue;
            const QRectF bar(x, y + row * 0.12, area.width() * number / most, row * 0.76);
            fill(painter, bar, fate);
            write_in(painter, bar, QString::number(number), fate);
            x += bar.width();
        }
        painter.setPen(ink);
        painter.drawText(QRectF(x + 6, y, 44, row), Qt::AlignLeft | Qt::AlignVCenter,
                         QString::number(all(level)));
    }
}

void OctreeChart::draw_held(QPainter& painter, const QRectF& whole) const {
    QRectF area = headed(painter, whole, "Undivided cells visited, by objects in them");
    const auto counts = facts_->held_counts(level());
    if (counts.empty()) {
        painter.setPen(quiet);
        painter.drawText(area, Qt::AlignLeft | Qt::AlignTop, "None down to this level.");
        return;
    }
    const double line = painter.fontMetrics().height();
    area.adjust(8, line, 0, -2 * line - 4);
    int most = 1;
    for (const auto& [held, number] : counts) most = std::max(most, number);
    const double column = std::min(area.width() / double(counts.size()), 56.0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const auto& [held, number] = counts[i];
        const double high = area.height() * number / most, x = area.left() + column * double(i);
        painter.fillRect(QRectF(x + column * 0.15, area.bottom() - high, column * 0.7, high), quiet);
        painter.setPen(ink);
        painter.drawText(QRectF(x, area.bottom() - high - line, column, line), Qt::AlignCenter,
                         QString::number(number));
        painter.drawText(QRectF(x, area.bottom() + 2, column, line), Qt::AlignCenter, QString::number(held));
    }
    painter.setPen(quiet);
    painter.drawText(QRectF(area.left(), area.bottom() + line + 2, area.width(), line), Qt::AlignLeft,
                     "objects in the cell; number on top: cells");
}

void OctreeChart::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::white);
    const QRectF area = QRectF(rect()).adjusted(8, 6, -8, -4);
    if (!facts_) {
        painter.setPen(quiet);
        painter.drawText(area, Qt::AlignTop | Qt::AlignLeft | Qt::TextWordWrap, nothing_);
        return;
    }
    constexpr double counters = 54, gap = 8;
    draw_counters(painter, {area.left(), area.top(), area.width(), counters});
    const double rest = area.height() - counters - 3 * gap, top = area.top() + counters + gap;
    draw_along(painter, {area.left(), top, area.width(), rest * 0.42});
    draw_levels(painter, {area.left(), top + rest * 0.42 + gap, area.width(), rest * 0.33});
    draw_held(painter, {area.left(), top + rest * 0.75 + 2 * gap, area.width(), rest * 0.25});
}

} // namespace rayscope::window
