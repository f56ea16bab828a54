#pragma once
// Boolean operations on inside lists: the heart of compound objects.

#include "core/generics/spans.hpp"
#include "core/trace/operation.hpp"

namespace rayscope {

/// Inside lists on a stack, in one contiguous buffer: no allocation once it has grown.
/// A list is its crossings in ascending order, entering and leaving in turn; unbounded ends have t = ±inf.
template <Scalar T> class SpanStack {
public:
    void clear() {
        crossings_.clear();
        starts_.clear();
    }
    /// Opens an empty list on top; append adds to it.
    void push() { starts_.push_back(crossings_.size()); }
    void append(const Crossing<T>& crossing) { crossings_.push_back(crossing); }

    [[nodiscard]] const Crossing<T>* top_begin() const { return crossings_.data() + starts_.back(); }
    [[nodiscard]] Crossing<T>* top_begin() { return crossings_.data() + starts_.back(); }
    [[nodiscard]] std::size_t top_size() const { return crossings_.size() - starts_.back(); }
    void resize_top(std::size_t size) { crossings_.resize(starts_.back() + size); }

    /// Replaces the two topmost lists A (below) and B (on top) by A op B.
    void combine(Operation operation);
    /// Replaces the topmost list by what lies outside it.
    void complement();

private:
    void sweep(Operation operation, std::size_t a, std::size_t b);

    std::vector<Crossing<T>> crossings_;
    std::vector<std::size_t> starts_;
};

/// Is the ray inside A op B, where it is inside A and B or not?
[[nodiscard]] constexpr bool holds(Operation operation, bool in_a, bool in_b) {
    switch (operation) {
    case Operation::set_union: return in_a || in_b;
    case Operation::intersection: return in_a && in_b;
    case Operation::difference: return in_a && !in_b;
    case Operation::complement:
    case Operation::leaf: break; // not of two operands
    }
    return in_a;
}

extern template class SpanStack<float>;
extern template class SpanStack<double>;
extern template class SpanStack<long double>;
extern template class SpanStack<Float128>;

} // namespace rayscope
