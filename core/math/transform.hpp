#pragma once
// From world to object space and back, for one solid.

#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

/// The inverse of a solid's affine matrix M.
///
/// Stable: the inverse of the linear part is computed in 113 bits and rounded once, and the translation T is kept apart:
/// object point = inverse · (world point − T). Forming the difference first keeps the digits of a solid far from the
/// origin. Textbook: adjugate / determinant in the ray's own numbers, and M⁻¹ o + column, which cancels there.
template <Numbers N> class Transform {
public:
    using T = ScalarOf<N>;

    Transform() = default;
    /// @param matrix affine, last row (0 0 0 1), invertible (see is_invertible).
    explicit Transform(const Mat4d& matrix);
    /// By a translation alone.
    [[nodiscard]] static Transform moving(const Vec3d& offset) {
        Transform result;
        result.translation_ = as<T>(offset);
        if constexpr (is_textbook<N>) result.column_ = -result.translation_;
        return result;
    }

    [[nodiscard]] Ray<T> to_object(const Ray<T>& ray) const {
        return {point_to_object(ray.origin), apply(ray.direction)};
    }
    [[nodiscard]] Vec3<T> vector_to_object(const Vec3<T>& v) const { return apply(v); }
    [[nodiscard]] Vec3<T> point_to_object(const Vec3<T>& point) const {
        if constexpr (is_textbook<N>) return apply(point) + column_;
        return apply(point - translation_);
    }

    /// Unit world normal of an object-space normal of any length: M⁻ᵀ n, normalized.
    [[nodiscard]] Vec3<T> normal_to_world(const Vec3<T>& n) const {
        if (only_moves_) return normalized(n);
        return normalized(
            Vec3<T>{column(n.x, n.y, n.z, 0), column(n.x, n.y, n.z, 1), column(n.x, n.y, n.z, 2)});
    }

    /// Per component: how far rounding can move the object-space ray point at t, in units of epsilon:
    /// |M⁻¹||o − T| + |t||M⁻¹||d| (Higham 2002, §3.1, applied to the two products).
    [[nodiscard]] Vec3<T> point_error(const Ray<T>& ray, T t) const {
        return spread(ray.origin - translation_) + magnitude(t) * spread(ray.direction);
    }

    /// The box, in object space, around a bounded box of world space.
    [[nodiscard]] Box<T> box_to_object(const Box<T>& box) const {
        const Vec3<T> middle = (box.low + box.high) / T(2), half = box.high - middle;
        const Vec3<T> centre = point_to_object(middle);
        const Vec3<T> rounding = spread(absolute(middle - translation_) + half) * (T(8) * epsilon<T>);
        const Vec3<T> reach = spread(half) + rounding;
        return {centre - reach, centre + reach};
    }

    /// How much farther than ε · (distance + size) rounding can put a crossing beside its solid, in world space: the
    /// matrix's condition, ‖columns of M‖ · ‖rows of M⁻¹‖. 3 where M only turns and scales along its own axes.
    [[nodiscard]] T distortion() const;

    /// M itself, back from its inverse: off by a few ε times distortion().
    [[nodiscard]] Mat4<T> matrix() const;

    [[nodiscard]] const Vec3<T>& translation() const { return translation_; }
    /// Object space is world space.
    [[nodiscard]] bool is_identity() const { return only_moves_ && translation_ == Vec3<T>{T(0)}; }

private:
    struct Nothing {};

    [[nodiscard]] T row(int i, const Vec3<T>& v) const {
        return fma(inverse_[i][0], v.x, fma(inverse_[i][1], v.y, inverse_[i][2] * v.z));
    }
    [[nodiscard]] T column(T x, T y, T z, int j) const {
        return fma(inverse_[0][j], x, fma(inverse_[1][j], y, inverse_[2][j] * z));
    }
    [[nodiscard]] Vec3<T> apply(const Vec3<T>& v) const {
        if (only_moves_) return v;
        return {row(0, v), row(1, v), row(2, v)};
    }
    [[nodiscard]] Vec3<T> spread(const Vec3<T>& v) const {
        if (only_moves_) return absolute(v);
        const auto part = [&](int i) {
            return magnitude(inverse_[i][0] * v.x) + magnitude(inverse_[i][1] * v.y) +
                   magnitude(inverse_[i][2] * v.z);
        };
        return {part(0), part(1), part(2)};
    }

    Mat3<T> inverse_{T(1)}; // inverse_[i] is row i, not GLM's column i
    Vec3<T> translation_{T(0)};
    bool only_moves_ = true; // the linear part is 1
    // M⁻¹'s own last column, −inverse · T: the textbook's alone.
    [[no_unique_address]] std::conditional_t<is_textbook<N>, Vec3<T>, Nothing> column_{};
};

/// True if every element is finite and the linear part can be inverted without leaving the number range.
[[nodiscard]] bool is_invertible(const Mat4d& matrix);

/// If the matrix keeps spheres round (rotation, mirror, translation and one scale for all axes, within the rounding of
/// T): that scale; otherwise 0. To a wider type than double, a rotation that was rounded to double is none.
template <Scalar T> [[nodiscard]] T similarity_scale(const Mat4d& matrix);

extern template class Transform<float>;
extern template class Transform<double>;
extern template class Transform<long double>;
extern template class Transform<Float128>;
extern template class Transform<Textbook<float>>;
extern template class Transform<Textbook<double>>;
extern template class Transform<Textbook<long double>>;
extern template class Transform<Textbook<Float128>>;

} // namespace rayscope
