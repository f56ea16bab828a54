#pragma once
// A generic shape at its place in the world.

#include "core/generics/generic.hpp"
#include "core/math/transform.hpp"

#include <optional>

namespace rayscope {

template <typename Shape> inline constexpr bool is_mesh = requires(const Shape& shape) { shape.triangles(); };

/// How far a point is, about, from a face.
template <typename Shape, Scalar T>
[[nodiscard]] T face_distance(const Shape& shape, const Vec3<T>& p, [[maybe_unused]] int face) {
    if constexpr (is_mesh<Shape>)
        return shape.value(p, face);
    else
        return magnitude(shape.value(p));
}

template <Numbers N> struct Solid {
    using T = ScalarOf<N>;

    Generic<N> shape;
    Transform<N> transform;
    std::uint32_t object = 0;   ///< index into World::objects
    std::uint32_t material = 0; ///< local light of its walls: index into World::materials
    T reach = T(0); ///< the largest coordinate of its bounds, or, where those are infinite, of a part
    bool holds_object = true; ///< nothing of its object lies outside of it
    bool is_ball = false; ///< a sphere in world space: its transform is a translation, its radius the world's

    /// The inside list on a world ray's whole line: the ray is moved, t is the same in both spaces.
    /// Of a mesh it may be but the beginning: see append_crossings.
    /// @param leaving the face on which the ray starts: its crossing is then t = 0 exactly; or no_face
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        if (is_ball)
            return std::get<Sphere<N>>(shape).intervals({ray.origin - transform.translation(), ray.direction},
                                                        leaving);
        const Ray<T> moved = transform.to_object(ray);
        return std::visit([&](const auto& s) { return s.intervals(moved, leaving); }, shape);
    }

    /// Unit outward world normal of a face where a ray crosses it.
    [[nodiscard]] Vec3<T> normal(const Ray<T>& ray, T t, int face) const {
        const Vec3<T> p = transform.to_object(ray).at(t);
        return transform.normal_to_world(std::visit([&](const auto& s) { return s.normal(p, face); }, shape));
    }

    /// Bound on |t − exact t| of a crossing, first order in ε with the second order where a ray grazes.
    /// If rounding moves the object-space point by e = 4ε(|M⁻¹||o − T| + |t||M⁻¹||d|), the surface's function moves by
    /// δ = n·e for its unit normal n, and its root on a line with slope s = n·d′ and curvature h by δ / s, or by
    /// √(2δ / h) where s → 0 (see `root_shift`).
    /// The schoolbook has no bounds: 0.
    /// @param off the surface may lie this far from where the ray sees it, along its normal: world length
    [[nodiscard]] T error_bound(const Ray<T>& ray, T t, int face, T off = T(0)) const {
        if (is_textbook<N> || !is_finite(t)) return T(0);
        const Ray<T> moved = transform.to_object(ray);
        const Vec3<T> p = moved.at(t), error = point_error(ray, t);
        return std::visit(
            [&](const auto& s) { return bound_at(s, moved, p, error, s.normal(p, face), face, off); }, shape);
    }

    /// Both at once, of a crossing at a finite t.
    struct Place {
        Vec3<T> normal;
        T error_bound;
    };
    [[nodiscard]] Place place(const Ray<T>& ray, T t, int face) const {
        const Ray<T> moved = transform.to_object(ray);
        const Vec3<T> p = moved.at(t), error = is_textbook<N> ? p : point_error(ray, t);
        const auto of = [&](const auto& s) -> Place {
            const Vec3<T> n = s.normal(p, face);
            const Vec3<T> unit = transform.normal_to_world(n);
            if constexpr (is_textbook<N>)
                return {unit, T(0)};
            else
                return {unit, bound_at(s, moved, p, error, n, face, T(0))};
        };
        if (is_ball) return of(std::get<Sphere<N>>(shape)); // what most rays hit: inlined here
        return std::visit(of, shape);
    }

    /// Whether the ray, up to t, keeps as close to the face as it may have started beside it: a start that lies so far off
    /// meets the surface there, however small the bound of a crossing that is no longer a graze.
    /// @param off how far the start may lie from the surface: world length
    [[nodiscard]] bool hugs(const Ray<T>& ray, T t, int face, T off) const {
        const Ray<T> moved = transform.to_object(ray);
        return std::visit(
            [&](const auto& s) {
                const Vec3<T> n = s.normal(moved.origin, face);
                const T limit = moved_off(n, off) + surface_distance(point_error(ray, t), n);
                return face_distance(s, moved.at(t / T(2)), face) * length(n) <= T(2) * limit;
            },
            shape);
    }

    /// The first crossing with t in the range; the query of the hot path, for solids that are no operands.
    [[nodiscard]] std::optional<Crossing<T>> closest(const Ray<T>& ray, const Range<T>& range,
                                                     std::uint32_t index) const {
        if (std::holds_alternative<Mesh<N>>(shape)) return closest_of_mesh(ray, range, index);
        if (const auto* polygon = std::get_if<Polygon<N>>(&shape)) {
            const auto t = polygon->closest(transform.to_object(ray), range);
            return t ? std::optional(Crossing<T>{*t, {index, 0, false}, true}) : std::nullopt;
        }
        for (const Interval<T>& inside : intervals(ray)) {
            if (range.contains(inside.enter))
                return Crossing<T>{inside.enter, {index, std::int32_t(inside.enter_face), false}, true};
            if (range.contains(inside.exit))
                return Crossing<T>{inside.exit, {index, std::int32_t(inside.exit_face), false}, false};
        }
        return std::nullopt;
    }

    // Not inlined, so that the others' query stays small.
    [[nodiscard, gnu::noinline]] std::optional<Crossing<T>>
    closest_of_mesh(const Ray<T>& ray, const Range<T>& range, std::uint32_t index) const {
        const auto first = std::get<Mesh<N>>(shape).closest(transform.to_object(ray), range);
        return first ? std::optional(crossing_of(*first, index)) : std::nullopt;
    }

    /// A triangle of a mesh that is this solid.
    [[nodiscard]] static Crossing<T> crossing_of(const MeshCrossing<T>& c, std::uint32_t index) {
        return {c.t, {index, std::int32_t(c.triangle), false}, c.entering};
    }

    /// A world length along a face's normal in object space, times the length of the normal.
    [[nodiscard]] T moved_off(const Vec3<T>& normal, T off) const {
        if (!(off > T(0))) return T(0);
        return off * magnitude(dot(normal, transform.vector_to_object(transform.normal_to_world(normal))));
    }

    /// e above.
    [[nodiscard]] Vec3<T> point_error(const Ray<T>& ray, T t) const {
        return T(4) * epsilon<T> * transform.point_error(ray, t);
    }
    /// Size of δ above: how far, in object space along the normal, the computed crossing can lie from the surface, times the
    /// length of the normal. At a cone's apex that vanishes: what then moves the form (x² + y² − w²) / 2 is e² / 2.
    [[nodiscard]] static T surface_distance(const Vec3<T>& e, const Vec3<T>& normal) {
        return fma(dot(e, e), T(0.5), dot(absolute(normal), e));
    }

private:
    // error_bound where the object-space ray, its point p at t with its error, and the normal there are known.
    template <typename Shape>
    [[nodiscard]] T bound_at(const Shape& s, const Ray<T>& moved, const Vec3<T>& p, const Vec3<T>& error,
                             const Vec3<T>& n, int face, T off) const;
};

/// How far the root of s t + h t² / 2 moves at most when the function moves by ±delta.
template <Scalar T> [[nodiscard]] inline T root_shift(T delta, T slope, T curvature) {
    slope = magnitude(slope);
    if (!(curvature > T(0))) return delta / slope;
    const T half_chord = slope / curvature;
    const T change = T(2) * delta / curvature; // of the squared half chord
    const T squared = half_chord * half_chord;
    if (squared < change) return sqrt(change);
    return change / (half_chord + sqrt(squared - change));
}

template <Numbers N>
template <typename Shape>
auto Solid<N>::bound_at(const Shape& s, const Ray<T>& moved, const Vec3<T>& p, const Vec3<T>& error,
                        const Vec3<T>& n, int face, T off) const -> T {
    // All of it scales with the normal's length, so that it need not be 1.
    T curvature = s.curvature(p, moved.direction, face);
    if (curvature > T(0)) curvature *= sqrt(dot(n, n));
    T delta = surface_distance(error, n) + moved_off(n, off);
    if constexpr (is_mesh<Shape>) delta += s.tilt(p, face);
    return root_shift(delta, dot(n, moved.direction), curvature);
}

} // namespace rayscope
