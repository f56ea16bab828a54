#include "core/boxes/box_tree.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

constexpr int bins = 16;
constexpr int unbalanced = 40; // deeper, halves of equal number are taken, so that the depth stays bounded

float outward(double x, bool up) {
    const float rounded = float(x);
    if (up ? double(rounded) >= x : double(rounded) <= x) return rounded;
    return std::nextafter(rounded, up ? infinity<float> : -infinity<float>);
}

float centre(const Box<float>& box, int axis) { return (box.low[axis] + box.high[axis]) / 2; }

} // namespace

double tree_scale(double size) { return size > 0 ? std::ldexp(1.0, std::min(1000, -std::ilogb(size))) : 1.0; }

Box<float> scaled_outward(const Box<double>& box, double scale) {
    Box<float> result;
    for (int axis = 0; axis < 3; ++axis) {
        result.low[axis] = outward(box.low[axis] * scale, false);
        result.high[axis] = outward(box.high[axis] * scale, true);
    }
    return result;
}

BoxTree BoxTreeBuilder::build() {
    if (items_.empty()) return {};
    const Part whole = part(0, items_.size());
    const std::uint32_t root = make(whole, 0);
    if ((root & Node8::leaf) != 0) // a single leaf still hangs on a node
        tree_.nodes.emplace_back().set(0, whole.box, root);
    tree_.nodes.shrink_to_fit();
    return std::move(tree_);
}

auto BoxTreeBuilder::part(std::size_t first, std::size_t last) const -> Part {
    Part result{first, last, {}};
    for (std::size_t i = first; i < last; ++i) {
        result.box = united(result.box, items_[i].box);
        result.cost += items_[i].cost;
    }
    return result;
}

auto BoxTreeBuilder::best_cut(const Part& whole) const -> Cut {
    Box<float> centres;
    for (std::size_t i = whole.first; i < whole.last; ++i)
        centres.include((items_[i].box.low + items_[i].box.high) / 2.0F);
    Cut best;
    for (int axis = 0; axis < 3; ++axis) {
        const float low = centres.low[axis], width = centres.high[axis] - low;
        if (!(width > 0)) continue;
        const float per_bin = bins / width;
        if (!is_finite(per_bin)) continue;
        std::array<Box<float>, bins> boxes{};
        std::array<std::size_t, bins> counts{};
        std::array<float, bins> costs{};
        for (std::size_t i = whole.first; i < whole.last; ++i) {
            const auto bin =
                std::size_t(minimum(float(bins - 1), (centre(items_[i].box, axis) - low) * per_bin));
            boxes[bin] = united(boxes[bin], items_[i].box);
            ++counts[bin];
            costs[bin] += items_[i].cost;
        }
        std::array<float, bins> after{}; // cost of bins i … last
        Box<float> box;
        float side = 0;
        for (std::size_t i = bins; i-- > 1;) {
            box = united(box, boxes[i]);
            side += costs[i];
            after[i] = half_area(box) * side;
        }
        box = {};
        side = 0;
        std::size_t count = 0;
        for (std::size_t i = 1; i < bins; ++i) {
            box = united(box, boxes[i - 1]);
            side += costs[i - 1];
            count += counts[i - 1];
            const float cost = half_area(box) * side + after[i];
            if (count > 0 && count < whole.size() && cost < best.cost)
                best = {axis, low + float(i) / per_bin, cost};
        }
    }
    return best;
}

/// @return where the second part begins
std::size_t BoxTreeBuilder::divide(const Part& whole, int depth) {
    const auto at = [&](std::size_t i) { return items_.begin() + std::ptrdiff_t(i); };
    const std::size_t half = whole.first + whole.size() / 2;
    if (depth < unbalanced) {
        if (const Cut cut = best_cut(whole); cut.axis >= 0) {
            const auto middle = std::partition(at(whole.first), at(whole.last), [&](const BoxedItem& item) {
                return centre(item.box, cut.axis) < cut.place;
            });
            const auto index = std::size_t(middle - items_.begin());
            if (index > whole.first && index < whole.last) return index;
        }
    }
    return half; // all centres in one place: any half is as good
}

std::uint32_t BoxTreeBuilder::make(const Part& whole, int depth) {
    tree_.depth = std::max(tree_.depth, depth);
    if (fits_a_leaf(whole))
        return make_leaf_(std::span(items_).subspan(whole.first, whole.size())) | Node8::leaf;
    std::array<Part, 8> parts{whole};
    std::size_t count = 1;
    while (count < 8) {
        const auto weight = [&](const Part& p) { return fits_a_leaf(p) ? -1.0F : half_area(p.box) * p.cost; };
        auto* const largest =
            std::max_element(parts.begin(), parts.begin() + std::ptrdiff_t(count),
                             [&](const Part& a, const Part& b) { return weight(a) < weight(b); });
        if (fits_a_leaf(*largest)) break;
        const Part divided = *largest;
        const std::size_t middle = divide(divided, depth);
        *largest = part(divided.first, middle);
        parts[count++] = part(middle, divided.last);
    }
    const auto index = std::uint32_t(tree_.nodes.size());
    tree_.nodes.emplace_back();
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t child = make(parts[i], depth + 1);
        tree_.nodes[index].set(i, parts[i].box, child);
    }
    return index;
}

} // namespace rayscope
