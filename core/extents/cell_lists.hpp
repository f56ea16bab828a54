#pragma once
// A grid of cells, each with a list of what is seen through it, nearest first.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace rayscope {

class CellLists {
public:
    /// An object, the cells that it is seen through (both ends included), and its least distance.
    struct Item {
        int left, top, right, bottom;
        float nearest;
        std::uint32_t object;
    };
    struct Entry {
        float nearest;
        std::uint32_t object;
    };

    CellLists() = default;
    /// Cells are joined two by two until the lists have a length in proportion to the number of items: a crowd in front of
    /// the eye fills all cells, and would fill all memory.
    /// @param items in the order of nearest_first
    CellLists(int width, int height, std::span<const Item> items);

    /// Sorts by the least distance, then by the object.
    static void nearest_first(std::vector<Item>& items);

    [[nodiscard]] std::span<const Entry> at(int x, int y) const {
        const std::size_t cell =
            std::size_t(y >> coarser_) * std::size_t(width_) + std::size_t(x >> coarser_);
        return {entries_.data() + starts_[cell], starts_[cell + 1] - starts_[cell]};
    }
    [[nodiscard]] std::size_t size() const { return entries_.size(); }
    /// So many times two cells are joined along each axis.
    [[nodiscard]] int coarser() const { return coarser_; }
    [[nodiscard]] std::size_t bytes() const {
        return entries_.capacity() * sizeof(Entry) + starts_.capacity() * sizeof(std::uint32_t);
    }

private:
    int width_ = 0, height_ = 0, coarser_ = 0;
    std::vector<std::uint32_t> starts_;
    std::vector<Entry> entries_;
};

} // namespace rayscope
