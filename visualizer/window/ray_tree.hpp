#pragma once
// The recursion tree. Its model reads the trace itself: a tree of thousands of rays costs nothing but what is seen.

#include "core/rayscope.hpp"

#include <QTreeView>

#include <functional>
#include <utility>

namespace rayscope::window {

/// Below each ray stand the rays that it spawned, and those that a limit kept from being followed.
class RayTreeModel : public QAbstractItemModel {
public:
    /// The trace must live until the next one is shown; rays lighter than `least` are left out.
    void show(const Trace* trace, double least);
    [[nodiscard]] const Trace* trace() const { return trace_; }
    [[nodiscard]] QModelIndex index_of(int ray, int column = 0) const;
    /// Of a ray that was not followed: the one that would have spawned it.
    [[nodiscard]] int ray_of(const QModelIndex& index) const;
    [[nodiscard]] int left_out() const { return left_out_; }
    /// Rows of rays that a limit kept from being followed.
    [[nodiscard]] std::size_t not_followed() const { return cuts_.size(); }

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    /// Rows that are no rays, counted after them.
    [[nodiscard]] const std::pair<int, const NotSpawned*>* cut(const QModelIndex& index) const;

    const Trace* trace_ = nullptr;
    std::vector<std::vector<int>>
        children_; // of each ray those that are shown; from the number of rays on: cuts
    std::vector<std::pair<int, const NotSpawned*>> cuts_; // with the ray that they would have come from
    std::vector<int> rows_;                               // of each ray its place among them; −1: left out
    int left_out_ = 0;
};

class RayTree : public QTreeView {
public:
    RayTree();
    std::function<void(int ray)> on_ray;

    void show_trace(const Trace* trace, double least);
    void show_ray(int ray);
    /// What stands in the row of the current ray, for tests.
    [[nodiscard]] QStringList current_row() const;
    [[nodiscard]] int left_out() const { return model_.left_out(); }
    [[nodiscard]] std::size_t not_followed() const { return model_.not_followed(); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    RayTreeModel model_;
    bool showing_ = false; // what is selected was not chosen by hand
};

} // namespace rayscope::window
