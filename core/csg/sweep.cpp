#include "core/csg/sweep.hpp"

#include <algorithm>

namespace rayscope {

template <Scalar T> void SpanStack<T>::combine(Operation operation) {
    const std::size_t b = starts_.back();
    const std::size_t a = starts_[starts_.size() - 2];
    starts_.pop_back();
    const bool a_empty = a == b, b_empty = b == crossings_.size();
    if (b_empty) { // A ∪ ∅ = A − ∅ = A; A ∩ ∅ = ∅
        if (operation == Operation::intersection) crossings_.resize(a);
    } else if (a_empty) { // ∅ ∪ B = B, which already lies where the result belongs
        if (operation != Operation::set_union) crossings_.resize(a);
    } else {
        sweep(operation, a, b);
    }
}

// Walk along the ray over both lists at once. Crossings with equal t are taken together, and only a change of the
// result is a boundary: so A − A is empty, and two solids that touch face to face unite without a seam.
template <Scalar T> void SpanStack<T>::sweep(Operation operation, std::size_t a, std::size_t b) {
    const std::size_t end = crossings_.size();
    std::size_t i = a, j = b;
    // Before B begins, A ∪ B and A − B are A, and A ∩ B is nothing. What is A's stays where it lies: a chain that adds
    // part after part would otherwise copy all parts before at every step.
    while (i < b && crossings_[i].t < crossings_[b].t) ++i;
    const std::size_t untouched = operation == Operation::intersection ? a : i;
    bool in_a = i > a && crossings_[i - 1].entering;
    bool in_b = false;
    bool inside = holds(operation, in_a, in_b);
    while (j < end || (i < b && operation != Operation::intersection)) {
        const bool take_a = i < b && (j == end || crossings_[i].t <= crossings_[j].t);
        const bool take_b = j < end && (i == b || crossings_[j].t <= crossings_[i].t);
        // Where both have a crossing and the result changes, both run its way: the face is the left operand's.
        Crossing<T> boundary = take_a ? crossings_[i] : crossings_[j];
        if (take_a) in_a = crossings_[i++].entering;
        if (take_b) in_b = crossings_[j++].entering;
        if (holds(operation, in_a, in_b) == inside) continue;
        inside = !inside;
        if (!take_a && operation == Operation::difference)
            boundary.surface.flipped = !boundary.surface.flipped;
        boundary.entering = inside;
        crossings_.push_back(boundary);
    }
    const auto at = [this](std::size_t index) { return crossings_.begin() + std::ptrdiff_t(index); };
    crossings_.erase(std::move(at(end), crossings_.end(), at(untouched)), crossings_.end());
}

template <Scalar T> void SpanStack<T>::complement() {
    const std::size_t start = starts_.back();
    for (std::size_t i = start; i < crossings_.size(); ++i) {
        crossings_[i].entering = !crossings_[i].entering;
        crossings_[i].surface.flipped = !crossings_[i].surface.flipped;
    }
    // An end at infinity appears where there was none, and goes where there was one.
    const auto first = crossings_.begin() + std::ptrdiff_t(start);
    if (first != crossings_.end() && first->t == -infinity<T>)
        crossings_.erase(first);
    else
        crossings_.insert(first, {-infinity<T>, {}, true});
    if (crossings_.size() > start && crossings_.back().t == infinity<T>)
        crossings_.pop_back();
    else
        crossings_.push_back({infinity<T>, {}, false});
}

template class SpanStack<float>;
template class SpanStack<double>;
template class SpanStack<long double>;
template class SpanStack<Float128>;

} // namespace rayscope
