#include "core/bvh/bvh_builder.hpp"

#include "core/stage/apart.hpp"

#include <chrono>

namespace rayscope {
namespace {

constexpr std::size_t capacity = 8; // of a leaf: as many balls as are tested at once
constexpr int bins = 16;
constexpr int unbalanced = 40; // deeper, halves of equal number are taken, so that the depth stays bounded

float outward(double x, bool up) {
    const float rounded = float(x);
    if (up ? double(rounded) >= x : double(rounded) <= x) return rounded;
    return std::nextafter(rounded, up ? infinity<float> : -infinity<float>);
}

Box<float> outward(const Box<double>& box, double scale) {
    Box<float> result;
    for (int axis = 0; axis < 3; ++axis) {
        result.low[axis] = outward(box.low[axis] * scale, false);
        result.high[axis] = outward(box.high[axis] * scale, true);
    }
    return result;
}

// Half of a box's surface; 0 for an empty one.
float area(const Box<float>& box) {
    const Vec3<float> d = box.high - box.low;
    return d.x < 0 ? 0 : d.x * d.y + d.y * d.z + d.z * d.x;
}

float centre(const Box<float>& box, int axis) { return (box.low[axis] + box.high[axis]) / 2; }

} // namespace

template <Numbers N> void BvhBuilder<N>::build() {
    const auto begin = std::chrono::steady_clock::now();
    sort_out();
    if (!items_.empty()) {
        const std::uint32_t root = make(part(0, items_.size()), 0);
        if ((root & Node8::leaf) != 0) { // a single leaf still hangs on a node
            tree_.nodes_.emplace_back().set(0, part(0, items_.size()).box, root);
            tree_.places_of_nodes_ = tree_.places_of_leaves_ = {0};
        }
    }
    tree_.bins_.close();
    BvhStatistics& s = tree_.statistics_;
    s.nodes = tree_.nodes_.size();
    s.leaves = tree_.bins_.size();
    s.apart = tree_.apart_.size();
    s.bytes =
        tree_.nodes_.capacity() * sizeof(Node8) +
        (tree_.places_of_nodes_.capacity() + tree_.places_of_leaves_.capacity()) * sizeof(std::uint32_t) +
        tree_.bins_.bytes() + tree_.all_.capacity() * sizeof(std::uint32_t);
    s.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <Numbers N> void BvhBuilder<N>::sort_out() {
    const Reach reach = rayscope::sort_out(world_, tree_.apart_, tree_.all_);
    tree_.distortion_ = reach.distortion;
    if (!tree_.all_.empty() && reach.size() > 0)
        tree_.scale_ = std::ldexp(1.0, std::min(1000, -std::ilogb(reach.size())));
    items_.reserve(tree_.all_.size());
    for (const std::uint32_t id : tree_.all_)
        items_.push_back({outward(world_.objects[id].bounds, tree_.scale_), id});
}

template <Numbers N> auto BvhBuilder<N>::part(std::size_t first, std::size_t last) const -> Part {
    Part result{first, last, {}};
    for (std::size_t i = first; i < last; ++i) result.box = united(result.box, items_[i].box);
    return result;
}

template <Numbers N> auto BvhBuilder<N>::best_cut(const Part& whole) const -> Cut {
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
        for (std::size_t i = whole.first; i < whole.last; ++i) {
            const auto bin =
                std::size_t(minimum(float(bins - 1), (centre(items_[i].box, axis) - low) * per_bin));
            boxes[bin] = united(boxes[bin], items_[i].box);
            ++counts[bin];
        }
        std::array<float, bins> after{}; // cost of bins i … last
        Box<float> box;
        std::size_t count = 0;
        for (std::size_t i = bins; i-- > 1;) {
            box = united(box, boxes[i]);
            count += counts[i];
            after[i] = area(box) * float(count);
        }
        box = {};
        count = 0;
        for (std::size_t i = 1; i < bins; ++i) {
            box = united(box, boxes[i - 1]);
            count += counts[i - 1];
            const float cost = area(box) * float(count) + after[i];
            if (count > 0 && count < whole.size() && cost < best.cost)
                best = {axis, low + float(i) / per_bin, cost};
        }
    }
    return best;
}

/// @return where the second part begins
template <Numbers N> std::size_t BvhBuilder<N>::divide(const Part& whole, int depth) {
    const auto at = [&](std::size_t i) { return items_.begin() + std::ptrdiff_t(i); };
    const std::size_t half = whole.first + whole.size() / 2;
    if (depth < unbalanced) {
        if (const Cut cut = best_cut(whole); cut.axis >= 0) {
            const auto middle = std::partition(at(whole.first), at(whole.last), [&](const Item& item) {
                return centre(item.box, cut.axis) < cut.place;
            });
            const auto index = std::size_t(middle - items_.begin());
            if (index > whole.first && index < whole.last) return index;
        }
    }
    return half; // all centres in one place: any half is as good
}

template <Numbers N> std::uint32_t BvhBuilder<N>::make_leaf(const Part& whole) {
    std::vector<std::uint32_t>& objects = objects_of_leaf_;
    objects.clear();
    for (std::size_t i = whole.first; i < whole.last; ++i) objects.push_back(items_[i].object);
    std::ranges::sort(objects);
    tree_.places_of_leaves_.push_back(0);
    return tree_.bins_.add(world_, objects) | Node8::leaf;
}

template <Numbers N> std::uint32_t BvhBuilder<N>::make(const Part& whole, int depth) {
    tree_.statistics_.depth = std::max(tree_.statistics_.depth, depth);
    if (whole.size() <= capacity) return make_leaf(whole);
    std::array<Part, 8> parts{whole};
    std::size_t count = 1;
    while (count < 8) {
        const auto weight = [](const Part& p) {
            return p.size() > capacity ? area(p.box) * float(p.size()) : -1.0F;
        };
        auto* const largest =
            std::max_element(parts.begin(), parts.begin() + std::ptrdiff_t(count),
                             [&](const Part& a, const Part& b) { return weight(a) < weight(b); });
        if (largest->size() <= capacity) break;
        const Part divided = *largest;
        const std::size_t middle = divide(divided, depth);
        *largest = part(divided.first, middle);
        parts[count++] = part(middle, divided.last);
    }
    const auto index = std::uint32_t(tree_.nodes_.size());
    tree_.nodes_.emplace_back();
    tree_.places_of_nodes_.push_back(0);
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t child = make(parts[i], depth + 1);
        tree_.nodes_[index].set(i, parts[i].box, child);
        const bool is_leaf = (child & Node8::leaf) != 0;
        (is_leaf ? tree_.places_of_leaves_ : tree_.places_of_nodes_)[child & ~Node8::leaf] =
            std::uint32_t(8 * index + i);
    }
    return index;
}

template <Numbers N> Bvh<N>::Bvh(const World<N>& world) : StageBase<N, Bvh<N>>(world) {
    BvhBuilder<N>(world, *this).build();
}

template class BvhBuilder<double>;
template Bvh<double>::Bvh(const World<double>&);

} // namespace rayscope
