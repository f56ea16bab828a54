#pragma once
// The layer between two parallel planes: the piece that caps a cylinder and, three times, makes a cube.

#include "core/generics/spans.hpp"

namespace rayscope {

/// The t with |o + t d| < 1. A zero d is asked for, never divided by: 0 / 0 would be NaN (Ize 2013).
/// @param low_face, high_face the faces at −1 and +1
/// @param leaving the face that the ray starts on, if any: its crossing is t = 0 exactly
template <Scalar T> [[nodiscard]] Interval<T> slab(T o, T d, int low_face, int high_face, int leaving) {
    const bool on_a_face = leaving == low_face || leaving == high_face;
    if (d == T(0)) return magnitude(o) < T(1) && !on_a_face ? Interval<T>{} : Interval<T>::nothing();
    const T low = leaving == low_face ? T(0) : (T(-1) - o) / d;
    const T high = leaving == high_face ? T(0) : (T(1) - o) / d;
    return d > T(0) ? Interval<T>{low, high, low_face, high_face}
                    : Interval<T>{high, low, high_face, low_face};
}

/// The schoolbook's: one division, and nobody asks for a zero d. A ray in the plane of a face then has 0 · ∞ = NaN.
template <Scalar T> [[nodiscard]] Interval<T> textbook_slab(T o, T d, int low_face, int high_face) {
    const T inverse = T(1) / d;
    const T low = (T(-1) - o) * inverse, high = (T(1) - o) * inverse;
    return low < high ? Interval<T>{low, high, low_face, high_face}
                      : Interval<T>{high, low, high_face, low_face};
}

} // namespace rayscope
