#pragma once
// One triangle against one line, in the schoolbook's way and in one that leaves no gap to its neighbours.

#include "core/generics/outline.hpp"
#include "core/math/numbers.hpp"

#include <optional>

namespace rayscope {

template <Scalar T> struct LineInTriangle {
    T t;
    bool entering; ///< against the normal
};

/// What all triangles of one ray share.
template <Numbers N> class TriangleRay {
public:
    using T = ScalarOf<N>;

    explicit TriangleRay(const Ray<T>& ray) : ray_(ray), view_(ray) {}

    /// Where the line meets the triangle: its corners run counter-clockwise as seen from outside.
    [[nodiscard]] std::optional<LineInTriangle<T>> hit(const Vec3<T>& a, const Vec3<T>& b,
                                                       const Vec3<T>& c) const {
        if constexpr (is_textbook<N>) return textbook_hit(a, b, c);
        const auto seen_a = view_.corner(a), seen_b = view_.corner(b);
        const auto seen_c = view_.corner(c);
        if (seen_a.above == seen_b.above && seen_b.above == seen_c.above) return std::nullopt;
        const int turns =
            view_.turn(seen_a, seen_b) + view_.turn(seen_b, seen_c) + view_.turn(seen_c, seen_a);
        if (turns == 0) return std::nullopt;
        return LineInTriangle<T>{depth(a, b, c), (turns > 0) != view_.runs_up()};
    }

private:
    // On the triangle's plane; where rounding would take it out of the triangle, as at a graze, at its nearest corner.
    // So what lies in a box that the ray leaves out has no smaller t than what lies in it.
    [[nodiscard]] T depth(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) const {
        const Vec3<T> n = cross(b - a, c - a);
        const T t = dot(n, a - ray_.origin) / dot(n, ray_.direction);
        const T at_a = view_.depth(a), at_b = view_.depth(b), at_c = view_.depth(c);
        const T least = minimum(at_a, minimum(at_b, at_c)), most = maximum(at_a, maximum(at_b, at_c));
        if (!(magnitude(t) < infinity<T>)) return (least + most) / T(2); // a triangle without area
        return minimum(maximum(t, least), most);
    }

    /// Möller and Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, JGT 2(1), 1997.
    [[nodiscard]] std::optional<LineInTriangle<T>> textbook_hit(const Vec3<T>& a, const Vec3<T>& b,
                                                                const Vec3<T>& c) const {
        const Vec3<T> ab = b - a, ac = c - a, h = cross(ray_.direction, ac);
        const T determinant = dot(ab, h);
        if (determinant == T(0)) return std::nullopt;
        const Vec3<T> s = ray_.origin - a;
        const T u = dot(s, h) / determinant;
        if (u < T(0) || u > T(1)) return std::nullopt;
        const Vec3<T> q = cross(s, ab);
        const T v = dot(ray_.direction, q) / determinant;
        if (v < T(0) || u + v > T(1)) return std::nullopt;
        const T t = dot(ac, q) / determinant;
        if (!is_finite(t)) return std::nullopt;
        return LineInTriangle<T>{t, determinant > T(0)};
    }

    Ray<T> ray_;
    OutlineView<T> view_;
};

} // namespace rayscope
