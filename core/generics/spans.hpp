#pragma once
// The inside list: where a ray enters and leaves.

#include "core/math/interval.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace rayscope {

/// One face of one solid of the world. Exact ties between crossings are told apart by it.
struct Surface {
    std::uint32_t solid;
    std::int32_t face; ///< a mesh has as many as triangles
    bool flipped;      ///< part of what a compound subtracts: its normal is turned

    friend bool operator==(const Surface&, const Surface&) = default;
};

/// Where a ray passes through a surface. Normal and error bound follow from surface and t when they are needed.
template <Scalar T> struct Crossing {
    T t;
    Surface surface;
    bool entering;
};

/// One inside interval: the ray is inside for enter.t < t < exit.t; the ends may be infinite.
template <Scalar T> struct Span {
    Crossing<T> enter, exit;
};

/// An inside list: ascending, disjoint, not touching.
template <Scalar T> using Spans = std::vector<Span<T>>;

/// No face: the ray does not start on the solid.
inline constexpr int no_face = -1;

/// What one generic's kernel returns: no generic is entered more than twice by a line.
/// Surfaces without volume give intervals with enter == exit.
template <Scalar T> struct Intervals {
    std::array<Interval<T>, 2> items;
    int count = 0;

    Intervals() = default;
    /// An interval, unless it is empty: how a convex solid ends its kernel.
    explicit Intervals(const Interval<T>& only) {
        if (!only.empty()) append(only);
    }
    void append(const Interval<T>& interval) { items[std::size_t(count++)] = interval; }
    [[nodiscard]] const Interval<T>* begin() const { return items.data(); }
    [[nodiscard]] const Interval<T>* end() const { return items.data() + count; }
};

} // namespace rayscope
