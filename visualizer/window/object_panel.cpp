#include "visualizer/window/object_panel.hpp"

#include <QGridLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace rayscope::window {
namespace {

constexpr std::size_t most_listed = 1000;
constexpr int drawn_role = Qt::UserRole,
              grip_role = Qt::UserRole + 1; // index into grips_, if the row has one

const char* word_of(Presence presence) {
    switch (presence) {
    case Presence::shown: return "shown";
    case Presence::ghost: return "ghost";
    default: return "hidden";
    }
}

} // namespace

ObjectPanel::ObjectPanel(RayView& view) : view_(view) {
    setObjectName("objects");
    list_.setObjectName("object_list");
    list_.setHeaderLabels({"object", "in 3D", "made of"});
    list_.setUniformRowHeights(true);
    list_.setAlternatingRowColors(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 6, 6, 6);
    column->addWidget(&list_, 1);
    column->addWidget(new QLabel("The 3D view draws those that lie near the rays."));
    auto* grid = new QGridLayout;
    column->addLayout(grid);
    int at = 0;
    const auto add = [&](const char* text, const char* tip, auto&& act) {
        auto* button = new QPushButton(text);
        button->setToolTip(tip);
        button->setObjectName(QString("object_") + QString(text).toLower().replace(' ', '_'));
        grid->addWidget(button, at / 3, at % 3);
        ++at;
        QObject::connect(button, &QPushButton::clicked, this, act);
    };
    add("Show", "The chosen object as it is", [this] { set_presence(Presence::shown); });
    add("Ghost", "The chosen object as a faint outline", [this] { set_presence(Presence::ghost); });
    add("Hide", "The chosen object not at all", [this] { set_presence(Presence::hidden); });
    add("Isolate", "The chosen object alone", [this] { isolate(); });
    add("Explode", "A compound with all its operands, also those that a difference took away",
        [this] { explode(); });
    add("Show all", "Every object as it is", [this] { show_all(); });
    QObject::connect(&list_, &QTreeWidget::currentItemChanged, this, [this] { take_hold(); });
    QObject::connect(&list_, &QTreeWidget::itemClicked, this, [this] { take_hold(); });
    QObject::connect(&list_, &QTreeWidget::itemDoubleClicked, this, [this] {
        const auto id = chosen();
        if (!id) return;
        set_presence(Presence((int(view_.presence_of(*id)) + 1) % 3));
    });
}

void ObjectPanel::show_scene(const Scene& scene) {
    if (objects_ == scene.drawn.size() && list_.topLevelItemCount() > 0) {
        bool same = true;
        for (int i = 0; same && i < std::min(list_.topLevelItemCount(), int(most_listed)); ++i)
            same = list_.topLevelItem(i)->text(0).toStdString() ==
                   object_title(scene, scene.drawn[std::size_t(i)]);
        if (same) return refresh();
    }
    marking_ = true;
    fill(scene);
    marking_ = false;
    refresh();
}

void ObjectPanel::fill(const Scene& scene) {
    objects_ = scene.drawn.size();
    list_.clear();
    grips_.clear();
    QList<QTreeWidgetItem*> items;
    for (std::size_t i = 0; i < std::min(objects_, most_listed); ++i) {
        const SceneObject& object = scene.drawn[i];
        auto* item = new QTreeWidgetItem;
        item->setText(0, QString::fromStdString(object_title(scene, object)));
        if (object.is_compound)
            item->setText(2, QString::fromStdString(scene.compounds[object.index].expression));
        item->setData(0, drawn_role, qulonglong(i));
        add_operands(*item, scene, i);
        items << item;
    }
    list_.addTopLevelItems(items);
    if (objects_ > most_listed) {
        auto* more = new QTreeWidgetItem({QString("… and %1 more").arg(objects_ - most_listed)});
        more->setFlags(Qt::NoItemFlags);
        list_.addTopLevelItem(more);
    }
    list_.header()->resizeSection(0, 130);
    list_.header()->resizeSection(1, 70);
}

void ObjectPanel::add_operands(QTreeWidgetItem& item, const Scene& scene, std::size_t drawn) {
    for (const Grip& grip : grips_of(scene, drawn)) {
        QTreeWidgetItem* row = &item;
        if (scene.drawn[drawn].is_compound) {
            row = new QTreeWidgetItem(&item, {QString::fromStdString(generic_title(scene, grip.generic))});
            row->setData(0, drawn_role, qulonglong(drawn));
            row->setText(2, QString("operand, a ") + generic_name(scene.generics[grip.generic].shape));
        }
        row->setData(0, grip_role, qulonglong(grips_.size()));
        grips_.push_back(grip);
    }
}

void ObjectPanel::take_hold() {
    const QTreeWidgetItem* item = list_.currentItem();
    if (marking_ || item == nullptr) return;
    const QVariant grip = item->data(0, grip_role);
    view_.set_grip(grip.isValid() ? std::optional(grips_[std::size_t(grip.toULongLong())]) : std::nullopt);
}

void ObjectPanel::refresh() {
    for (int i = 0; i < list_.topLevelItemCount(); ++i) {
        QTreeWidgetItem* item = list_.topLevelItem(i);
        if (!(item->flags() & Qt::ItemIsEnabled)) continue;
        const auto id = std::size_t(item->data(0, drawn_role).toULongLong());
        QString text = word_of(view_.presence_of(id));
        if (view_.exploded().contains(id)) text = "exploded";
        item->setText(1, text);
    }
}

std::optional<std::size_t> ObjectPanel::chosen() const {
    const QTreeWidgetItem* item = list_.currentItem();
    if (item == nullptr || !(item->flags() & Qt::ItemIsEnabled)) return std::nullopt;
    return std::size_t(item->data(0, drawn_role).toULongLong());
}

void ObjectPanel::mark(std::optional<std::size_t> drawn) {
    if (drawn && (*drawn >= most_listed || int(*drawn) >= list_.topLevelItemCount())) return;
    const QTreeWidgetItem* current = list_.currentItem(); // perhaps one of its operands
    if (drawn && current != nullptr && current->data(0, drawn_role).toULongLong() == *drawn) return;
    marking_ = true;
    list_.setCurrentItem(drawn ? list_.topLevelItem(int(*drawn)) : nullptr);
    marking_ = false;
}

void ObjectPanel::mark_grip(const Grip& grip) {
    marking_ = true;
    for (QTreeWidgetItemIterator at(&list_); *at != nullptr; ++at)
        if (const QVariant index = (*at)->data(0, grip_role);
            index.isValid() && grips_[std::size_t(index.toULongLong())].generic == grip.generic) {
            list_.setCurrentItem(*at);
            break;
        }
    marking_ = false;
}

bool ObjectPanel::choose(const std::string& name) {
    const auto found = list_.findItems(QString::fromStdString(name), Qt::MatchExactly | Qt::MatchRecursive);
    if (found.isEmpty()) return false;
    list_.setCurrentItem(found.first());
    take_hold();
    return true;
}

void ObjectPanel::set_presence(Presence presence) {
    const auto id = chosen();
    if (!id) return;
    auto all = view_.presence();
    all[*id] = presence;
    view_.set_presence(std::move(all));
    refresh();
}

void ObjectPanel::isolate() {
    const auto id = chosen();
    if (!id) return;
    std::map<std::size_t, Presence> all;
    for (std::size_t i = 0; i < objects_; ++i) all[i] = i == *id ? Presence::shown : Presence::hidden;
    view_.set_presence(std::move(all));
    refresh();
}

void ObjectPanel::explode() {
    const auto id = chosen();
    if (!id) return;
    auto exploded = view_.exploded();
    if (!exploded.erase(*id)) exploded.insert(*id);
    view_.set_exploded(std::move(exploded));
    refresh();
}

void ObjectPanel::show_all() {
    view_.set_presence({});
    view_.set_exploded({});
    refresh();
}

} // namespace rayscope::window
