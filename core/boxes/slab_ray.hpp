#pragma once
// A ray made ready to be tested against many boxes.

#include "core/math/box.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

/// Transform::distortion() that the boxes of a compound's parts still make room for, in all numbers.
template <Scalar T> inline constexpr T most_distorted = T(1024);
/// The same of whole objects, which are put into boxes in double alone: a margin of a hundred millionth, less than floats
/// round.
inline constexpr double most_distorted_object = 0x1p20;

/// The t at which a ray is in a box.
template <Scalar T> struct BoxSpan {
    T enter, exit;
};

/// A hit that a kernel finds may lie beside its solid by rounding. Boxes are therefore met with a margin,
///     64 ε · distortion · (largest coordinate of the origin + largest coordinate of all boxes),
/// for most matrices a hundredth of what a graze would show, so that who passes by a box by more is found by no kernel
/// within it.
template <Scalar T> class SlabRay {
public:
    /// @param size the largest coordinate of any box that will be asked for
    /// @param distortion the largest Transform::distortion() of what the boxes hold
    /// @param beside the ray's origin may lie so far beside a box that it starts in
    SlabRay(const Ray<T>& ray, T size, T distortion, T beside = T(0))
        : origin_(ray.origin),
          margin_(
              fma(T(64) * epsilon<T> * distortion, largest_component(absolute(ray.origin)) + size, beside)) {
        for (int axis = 0; axis < 3; ++axis) inverse_[axis] = finite_inverse(ray.direction[axis]);
    }

    [[nodiscard]] const Vec3<T>& origin() const { return origin_; }
    /// 1 / direction; where that is infinite, a number so large that no t of a scene comes near it.
    [[nodiscard]] const Vec3<T>& inverse() const { return inverse_; }
    [[nodiscard]] T margin() const { return margin_; }
    /// False where coordinates are so large that products with `inverse` overflow: then no box can be relied on.
    [[nodiscard]] bool reliable() const { return margin_ < largest; }

    /// Where the ray is between the box's planes; enter > exit if it never is.
    [[nodiscard]] BoxSpan<T> span(const Box<T>& box) const {
        BoxSpan<T> inside{-infinity<T>, infinity<T>};
        for (int axis = 0; axis < 3; ++axis) {
            const T a = (box.low[axis] - margin_ - origin_[axis]) * inverse_[axis];
            const T b = (box.high[axis] + margin_ - origin_[axis]) * inverse_[axis];
            inside.enter = maximum(inside.enter, minimum(a, b));
            inside.exit = minimum(inside.exit, maximum(a, b));
        }
        inside.exit += T(4) * epsilon<T> * magnitude(inside.exit);
        return inside;
    }
    /// Whether the ray's whole line may pass through the box.
    [[nodiscard]] bool line_may_pass(const Box<T>& box) const {
        const BoxSpan<T> inside = span(box);
        return inside.enter <= inside.exit;
    }
    /// Whether a hit in the box may have 0 ≤ t ≤ limit.
    [[nodiscard]] bool may_hit(const Box<T>& box, T limit = infinity<T>) const {
        const BoxSpan<T> inside = span(box);
        return inside.enter <= inside.exit && inside.exit >= T(0) && inside.enter <= limit;
    }

private:
    static constexpr T huge = T(1) / limits::power_of_half<T>(std::is_same_v<T, float> ? 60 : 500);
    static constexpr T largest = T(1) / limits::power_of_half<T>(std::is_same_v<T, float> ? 30 : 300);

    [[nodiscard]] static T finite_inverse(T d) {
        const T inverse = T(1) / d;
        return magnitude(inverse) < huge ? inverse : (d < T(0) ? -huge : huge);
    }

    Vec3<T> origin_, inverse_;
    T margin_;
};

} // namespace rayscope
