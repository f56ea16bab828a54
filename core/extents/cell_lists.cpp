#include "core/extents/cell_lists.hpp"

namespace rayscope {
namespace {

std::size_t length(std::span<const CellLists::Item> items, int coarser) {
    std::size_t sum = 0;
    for (const auto& item : items)
        sum += std::size_t((item.right >> coarser) - (item.left >> coarser) + 1) *
               std::size_t((item.bottom >> coarser) - (item.top >> coarser) + 1);
    return sum;
}

} // namespace

void CellLists::nearest_first(std::vector<Item>& items) {
    std::sort(items.begin(), items.end(), [](const Item& a, const Item& b) {
        return a.nearest < b.nearest || (a.nearest == b.nearest && a.object < b.object);
    });
}

CellLists::CellLists(int width, int height, std::span<const Item> items) {
    const std::size_t most = 16 * items.size() + 65536;
    while ((1 << coarser_) < std::max(width, height) && length(items, coarser_) > most) ++coarser_;
    width_ = ((width - 1) >> coarser_) + 1;
    height_ = ((height - 1) >> coarser_) + 1;
    const auto each_cell = [&](const Item& item, const auto& use) {
        for (int y = item.top >> coarser_; y <= item.bottom >> coarser_; ++y)
            for (int x = item.left >> coarser_; x <= item.right >> coarser_; ++x)
                use(std::size_t(y) * std::size_t(width_) + std::size_t(x));
    };
    starts_.assign(std::size_t(width_) * std::size_t(height_) + 1, 0);
    for (const Item& item : items) each_cell(item, [&](std::size_t cell) { ++starts_[cell + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    entries_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (const Item& item : items)
        each_cell(item, [&](std::size_t cell) { entries_[next[cell]++] = {item.nearest, item.object}; });
}

} // namespace rayscope
