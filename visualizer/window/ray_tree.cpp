#include "visualizer/window/ray_tree.hpp"

#include "visualizer/drawing/palette.hpp"
#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/window/colours.hpp"
#include "visualizer/window/known_part.hpp"

#include <QHeaderView>
#include <QKeyEvent>
#include <QPainter>
#include <QPixmap>

namespace rayscope::window {
namespace {

enum Column { name, target, distance, share, columns };

/// A stroke as in the 3D view: shadow rays are dashed.
QPixmap stroke_of(const TracedRay& ray) {
    QPixmap pixmap(14, 12);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    QPen pen(qt_colour(drawing::ray_colour(ray)), 3);
    if (ray.start().kind == RayKind::shadow) pen.setDashPattern({1.4, 1});
    painter.setPen(pen);
    painter.drawLine(1, 6, 13, 6);
    return pixmap;
}

/// As many digits as the column has room for.
QString share_text(double weight) {
    return QString::fromStdString(drawing::number(weight, weight >= 0.01 ? 3 : weight >= 0.001 ? 2 : 1));
}

QString text_of(const Trace& trace, int id, int column) {
    const TracedRay& ray = trace.rays[std::size_t(id)];
    const bool known = is_finished(ray) || ray.find<BoundaryChosen>() != nullptr;
    if (!known && (column == target || column == distance)) return "?";
    switch (column) {
    case name: return QString::number(id) + " " + drawing::kind_name(ray.start().kind);
    case target: {
        QString text = QString::fromStdString(drawing::target_name(trace, ray));
        if (drawing::is_blocked(ray)) text += " (blocked)";
        if (ray.find<TotallyReflected>() != nullptr) text += " (total)";
        return text;
    }
    case distance: {
        const drawing::RayEnd end = drawing::drawn_end(ray, infinity<double>);
        return end.open ? QString("–") : QString::fromStdString(drawing::number(end.t, 4));
    }
    default: return share_text(weight(ray));
    }
}

/// The scene's limit that kept a ray from being followed; nothing for other reasons, which are no news here.
const char* limit_of(const NotSpawned& refused) {
    switch (refused.reason) {
    case Reason::depth: return "max_depth";
    case Reason::weight: return "min_weight";
    case Reason::ray_limit: return "max_rays";
    default: return nullptr;
    }
}

/// "no reflected ray": what its weight would have been, and the limit.
QString text_of(const NotSpawned& refused, int column) {
    switch (column) {
    case name: return QString("no %1 ray").arg(drawing::kind_name(refused.kind));
    case target: return limit_of(refused);
    case share: return share_text(largest_component(refused.weight));
    default: return "–";
    }
}

} // namespace

void RayTreeModel::show(const Trace* trace, double least) {
    beginResetModel();
    trace_ = trace;
    const std::size_t count = trace->rays.size();
    children_.assign(count, {});
    rows_.assign(count, -1);
    cuts_.clear();
    left_out_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const TracedRay& ray = trace->rays[i];
        const bool root = ray.parent == none;
        const bool kept = root || (rows_[std::size_t(ray.parent)] >= 0 && !(weight(ray) < least));
        if (!kept) {
            ++left_out_;
            continue;
        }
        auto* siblings = root ? nullptr : &children_[std::size_t(ray.parent)];
        rows_[i] = root ? 0 : int(siblings->size());
        if (siblings != nullptr) siblings->push_back(int(i));
    }
    for (std::size_t i = 0; i < count; ++i) {
        if (rows_[i] < 0) continue;
        for (const Event& event : trace->rays[i].events) {
            const auto* refused = std::get_if<NotSpawned>(&event);
            if (refused == nullptr || limit_of(*refused) == nullptr ||
                largest_component(refused->weight) < least)
                continue;
            children_[i].push_back(int(count + cuts_.size()));
            cuts_.emplace_back(int(i), refused);
        }
    }
    endResetModel();
}

const std::pair<int, const NotSpawned*>* RayTreeModel::cut(const QModelIndex& index) const {
    const auto id = std::size_t(index.internalId());
    return id < rows_.size() ? nullptr : &cuts_[id - rows_.size()];
}

int RayTreeModel::ray_of(const QModelIndex& index) const {
    const auto* refused = cut(index);
    return refused != nullptr ? refused->first : int(index.internalId());
}

QModelIndex RayTreeModel::index_of(int ray, int column) const {
    if (trace_ == nullptr || ray < 0 || std::size_t(ray) >= rows_.size() || rows_[std::size_t(ray)] < 0)
        return {};
    return createIndex(rows_[std::size_t(ray)], column, quintptr(ray));
}

QModelIndex RayTreeModel::index(int row, int column, const QModelIndex& parent) const {
    if (trace_ == nullptr || row < 0) return {};
    if (!parent.isValid()) return row == 0 ? createIndex(0, column, quintptr(0)) : QModelIndex();
    if (cut(parent) != nullptr) return {};
    const auto& children = children_[std::size_t(ray_of(parent))];
    return std::size_t(row) < children.size() ? createIndex(row, column, quintptr(children[std::size_t(row)]))
                                              : QModelIndex();
}

QModelIndex RayTreeModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || trace_ == nullptr) return {};
    if (const auto* refused = cut(index)) return index_of(refused->first);
    return index_of(trace_->rays[std::size_t(ray_of(index))].parent);
}

int RayTreeModel::rowCount(const QModelIndex& parent) const {
    if (trace_ == nullptr || parent.column() > 0 || (parent.isValid() && cut(parent) != nullptr)) return 0;
    return parent.isValid() ? int(children_[std::size_t(ray_of(parent))].size()) : 1;
}

int RayTreeModel::columnCount(const QModelIndex& /*parent*/) const { return columns; }

QVariant RayTreeModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || trace_ == nullptr) return {};
    if (role == Qt::TextAlignmentRole && index.column() >= distance)
        return int(Qt::AlignRight | Qt::AlignVCenter);
    if (const auto* refused = cut(index)) {
        if (role == Qt::DisplayRole) return text_of(*refused->second, index.column());
        if (role == Qt::ForegroundRole) return QColor(0x60, 0x60, 0x60);
        if (role == Qt::ToolTipRole) return "Not followed: a limit of the scene was reached";
        return {};
    }
    const TracedRay& ray = trace_->rays[std::size_t(ray_of(index))];
    if (role == Qt::DisplayRole) return text_of(*trace_, ray_of(index), index.column());
    if (role == Qt::DecorationRole && index.column() == name) return stroke_of(ray);
    if (role == Qt::ForegroundRole && index.column() == name) return qt_colour(drawing::ray_text_colour(ray));
    return {};
}

QVariant RayTreeModel::headerData(int section, Qt::Orientation /*orientation*/, int role) const {
    static const std::array<const char*, columns> names{"ray", "arrives at", "t", "weight"};
    if (role == Qt::DisplayRole && section >= 0 && section < columns) return names[std::size_t(section)];
    if (role == Qt::TextAlignmentRole && section >= distance) return int(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

RayTree::RayTree() {
    setObjectName("tree");
    setAccessibleName("Recursion tree");
    setModel(&model_);
    setUniformRowHeights(true);
    setAlternatingRowColors(true);
    setSelectionBehavior(SelectRows);
    setIconSize({14, 12});
    setIndentation(10);
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(QHeaderView::Interactive);
    header()->setMinimumSectionSize(36);
    connect(selectionModel(), &QItemSelectionModel::currentChanged, this, [this](const QModelIndex& index) {
        if (!showing_ && index.isValid() && on_ray) on_ray(model_.ray_of(index));
    });
}

void RayTree::show_trace(const Trace* trace, double least) {
    showing_ = true;
    model_.show(trace, least);
    // All of a small tree is seen at once; of a large one the way to the current ray opens.
    if (trace->rays.size() <= 400) expandAll();
    showing_ = false;
}

void RayTree::resizeEvent(QResizeEvent* event) {
    QTreeView::resizeEvent(event);
    constexpr int number = 52;
    const int rest = std::max(viewport()->width() - 2 * number, 160), names = rest * 64 / 100;
    setColumnWidth(name, names);
    setColumnWidth(target, rest - names);
    setColumnWidth(distance, number);
    setColumnWidth(share, number);
}

void RayTree::show_ray(int ray) {
    const QModelIndex index = model_.index_of(ray);
    showing_ = true;
    if (index.isValid()) {
        setCurrentIndex(index);
        scrollTo(index);
    } else {
        selectionModel()->clearSelection();
    }
    showing_ = false;
}

QStringList RayTree::current_row() const {
    QStringList texts;
    const QModelIndex current = currentIndex();
    for (int column = 0; current.isValid() && column < columns; ++column)
        texts << model_.index_of(model_.ray_of(current), column).data().toString();
    return texts;
}

void RayTree::keyPressEvent(QKeyEvent* event) {
    // Letters move the walk; they do not search in the tree.
    if (event->text().isEmpty() || event->key() == Qt::Key_Return) return QTreeView::keyPressEvent(event);
    event->ignore();
}

} // namespace rayscope::window
