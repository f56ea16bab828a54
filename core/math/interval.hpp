#pragma once
// Intervals of t: what a convex solid's surfaces leave of a ray's line.

#include "core/math/scalar.hpp"

namespace rayscope {

/// The t with enter < t < exit. Each end keeps the face that made it.
template <Scalar T> struct Interval {
    T enter = -infinity<T>;
    T exit = infinity<T>;
    int enter_face = 0;
    int exit_face = 0;

    [[nodiscard]] bool empty() const { return !(enter < exit); }
    [[nodiscard]] static Interval nothing() { return {infinity<T>, -infinity<T>, 0, 0}; }
};

/// What two intervals share. On a tie the first one's face stays.
template <Scalar T> [[nodiscard]] Interval<T> intersection(const Interval<T>& a, const Interval<T>& b) {
    Interval<T> shared = a;
    if (b.enter > a.enter) {
        shared.enter = b.enter;
        shared.enter_face = b.enter_face;
    }
    if (b.exit < a.exit) {
        shared.exit = b.exit;
        shared.exit_face = b.exit_face;
    }
    return shared;
}

} // namespace rayscope
