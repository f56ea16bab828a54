#pragma once
// The axis-aligned box: an extent.

#include "core/math/vec.hpp"

namespace rayscope {

/// The points with low ≤ p ≤ high, component by component. May be unbounded; the default is empty.
template <Scalar T> struct Box {
    Vec3<T> low{infinity<T>};
    Vec3<T> high{-infinity<T>};

    [[nodiscard]] static Box everything() { return {Vec3<T>{-infinity<T>}, Vec3<T>{infinity<T>}}; }

    void include(const Vec3<T>& p) {
        for (int i = 0; i < 3; ++i) {
            low[i] = minimum(low[i], p[i]);
            high[i] = maximum(high[i], p[i]);
        }
    }
    [[nodiscard]] bool overlaps(const Box& other) const {
        for (int i = 0; i < 3; ++i)
            if (!(low[i] <= other.high[i] && other.low[i] <= high[i])) return false;
        return true;
    }
    [[nodiscard]] bool bounded() const {
        for (int i = 0; i < 3; ++i)
            if (!is_finite(low[i]) || !is_finite(high[i])) return false;
        return true;
    }
};

/// The box in another number type; not rounded outward.
template <Scalar To, Scalar From> [[nodiscard]] Box<To> as(const Box<From>& box) {
    return {as<To>(box.low), as<To>(box.high)};
}

/// Smallest box around both.
template <Scalar T> [[nodiscard]] Box<T> united(Box<T> a, const Box<T>& b) {
    for (int i = 0; i < 3; ++i) {
        a.low[i] = minimum(a.low[i], b.low[i]);
        a.high[i] = maximum(a.high[i], b.high[i]);
    }
    return a;
}

/// What both share; empty if low > high somewhere.
template <Scalar T> [[nodiscard]] Box<T> intersected(Box<T> a, const Box<T>& b) {
    for (int i = 0; i < 3; ++i) {
        a.low[i] = maximum(a.low[i], b.low[i]);
        a.high[i] = minimum(a.high[i], b.high[i]);
    }
    return a;
}

/// Of its corners, whatever its sign.
template <Scalar T> [[nodiscard]] T largest_coordinate(const Box<T>& box) {
    return largest_component(maximum_of(absolute(box.low), absolute(box.high)));
}

/// Half of a box's surface; 0 for an empty one. Of all lines through a convex box, as many go through one within it as the
/// ratio of their surfaces says: what every estimate of a walk's cost is made of.
template <Scalar T> [[nodiscard]] T half_area(const Box<T>& box) {
    const Vec3<T> d = box.high - box.low;
    return d.x < T(0) ? T(0) : d.x * d.y + d.y * d.z + d.z * d.x;
}

} // namespace rayscope
