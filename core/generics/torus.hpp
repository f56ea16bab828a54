#pragma once
// The torus with major radius 1 in the plane z = 0 and minor radius r < 1. Face 0.

#include "core/generics/slab.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"
#include "core/math/roots.hpp"

namespace rayscope {

template <Numbers N> struct Torus {
    using T = ScalarOf<N>;

    T minor = T(0.25); ///< 0 < minor < 1

    static constexpr const char* name = "torus";
    static constexpr bool solid = true;

    /// Up to four crossings, isolated and then polished.
    ///
    /// 1. Measure s, a length, from the point q of the line closest to the centre, and cut by the sphere and the
    ///    slab around the torus: all that follows has the size of the torus, wherever the ray comes from.
    /// 2. There the torus is the quartic (s² + bs + k)² − 4(As² + Bs + C) < 0, which turns where its derivative, a
    ///    cubic, changes sign: between two such places lies at most one crossing. No formula for quartic roots
    ///    (Ferrari's loses double roots).
    /// 3. Within each bracket, Newton on (ρ − 1)² + z² − minor², which has the quartic's sign but not its
    ///    cancellation, with ρ − 1 = (ρ² − 1) / (ρ + 1).
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        const Vec3<T>& d = ray.direction;
        const T dd = dot(d, d);
        const T middle = -dot(ray.origin, d) / dd;
        const Vec3<T> q = ray.at(middle);
        const T outer = T(1) + minor;
        const T reach_squared = outer * outer - dot(q, q);
        if (!(reach_squared > T(-8) * epsilon<T>)) return {};
        const T speed = sqrt(dd);
        const Line line{q, d / speed};
        const Interval<T> part = around(line, sqrt(maximum(reach_squared, T(0))));
        if (part.empty()) return {};

        std::array<T, 5> ends{};
        const int pieces = monotone_pieces(line, part, ends);
        std::array<T, 4> roots{};
        int count = 0;
        T from = part.enter;
        bool inside = distance(line, from).value < T(0);
        for (int i = 0; i < pieces; ++i) {
            const T to = ends[std::size_t(i)];
            const bool inside_at_end = distance(line, to).value < T(0);
            if (inside != inside_at_end)
                roots[std::size_t(count++)] = bracketed_root([&](T s) { return distance(line, s); }, from, to,
                                                             inside, epsilon<T>, from + (to - from) / T(2));
            from = to;
            inside = inside_at_end;
        }
        for (int i = 0; i < count; ++i) roots[std::size_t(i)] = roots[std::size_t(i)] / speed + middle;
        if (leaving == 0) start_on_surface(ray, roots, count);

        Intervals<T> found;
        for (int i = 0; i + 1 < count; i += 2) {
            const Interval<T> span{roots[std::size_t(i)], roots[std::size_t(i) + 1], 0, 0};
            if (!span.empty()) found.append(span);
        }
        return found;
    }

    /// Points away from the ring's core circle.
    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int /*face*/) const {
        const T rho = sqrt(fma(p.x, p.x, p.y * p.y));
        const T scale = rho > T(0) ? from_core(p.x, p.y, rho) / rho : T(0);
        return {p.x * scale, p.y * scale, p.z};
    }
    [[nodiscard]] T value(const Vec3<T>& p) const {
        const T rho = sqrt(fma(p.x, p.x, p.y * p.y));
        const T w = from_core(p.x, p.y, rho);
        return sqrt(fma(w, w, p.z * p.z)) - minor;
    }
    /// At most the larger of the two principal curvatures, times |d|².
    [[nodiscard]] T curvature(const Vec3<T>& /*p*/, const Vec3<T>& d, int /*face*/) const {
        return dot(d, d) / minimum(minor, T(1) - minor);
    }
    [[nodiscard]] Box<T> bounds() const {
        const T outer = T(1) + minor;
        return {Vec3<T>{-outer, -outer, -minor}, Vec3<T>{outer, outer, minor}};
    }

    template <Numbers M> [[nodiscard]] Torus<M> to() const { return {ScalarOf<M>(minor)}; }

private:
    struct Line {
        Vec3<T> q, e; // e is unit
    };

    // ρ − 1 without cancellation.
    [[nodiscard]] static T from_core(T x, T y, T rho) { return fma(x, x, fma(y, y, T(-1))) / (rho + T(1)); }

    [[nodiscard]] Jet<T> distance(const Line& line, T s) const {
        const T x = fma(s, line.e.x, line.q.x), y = fma(s, line.e.y, line.q.y),
                z = fma(s, line.e.z, line.q.z);
        const T rho = sqrt(fma(x, x, y * y));
        const T w = from_core(x, y, rho);
        const T rho_slope = rho > T(0) ? fma(x, line.e.x, y * line.e.y) / rho : T(0);
        return {fma(w, w, difference_of_products(z, z, minor, minor)),
                T(2) * fma(w, rho_slope, z * line.e.z)};
    }

    // Where the line is in the sphere and in the slab |z| ≤ minor, each a little larger than the torus.
    [[nodiscard]] Interval<T> around(const Line& line, T half_chord) const {
        const T margin = minor / T(64);
        const T half = half_chord + margin;
        const T thickness = minor + margin;
        return intersection(Interval<T>{-half, half, 0, 0},
                            slab(line.q.z / thickness, line.e.z / thickness, 0, 0, no_face));
    }

    // Ends, ascending, of pieces on which the quartic is monotone; the last one is part.exit.
    [[nodiscard]] int monotone_pieces(const Line& line, const Interval<T>& part,
                                      std::array<T, 5>& ends) const {
        const auto& [q, e] = line;
        const T k = fma(T(1) - minor, T(1) + minor, dot(q, q));
        const T b = T(2) * dot(q, e);
        const T A = fma(e.x, e.x, e.y * e.y), B = T(2) * fma(q.x, e.x, q.y * e.y);
        const std::array<T, 4> derivative{T(2) * b * k - T(4) * B, T(2) * (b * b + T(2) * k - T(4) * A),
                                          T(6) * b, T(4)};
        const CubicRoots<T> turns = cubic_sign_changes(derivative, part.enter, part.exit);
        for (int i = 0; i < turns.count; ++i) ends[std::size_t(i)] = turns.items[std::size_t(i)];
        ends[std::size_t(turns.count)] = part.exit;
        return turns.count + 1;
    }

    // The ray starts on the torus: of the crossings that run its way (in or out), the nearest one is t = 0 exactly.
    // If rounding has put the start δ beside the surface, that one lies about δ / |n·d| away; at a graze, where a double
    // root moves by √ε, it may be missing, and no other one is taken for it.
    void start_on_surface(const Ray<T>& ray, std::array<T, 4>& roots, int count) const {
        const T speed = length(ray.direction);
        const T slope = dot(normalized(normal(ray.origin, 0)), ray.direction);
        const bool outward = slope > T(0);
        const T offset = T(2) * magnitude(value(ray.origin)) / magnitude(slope);
        const T reach = maximum(T(4) * sqrt(epsilon<T>) / speed, minimum(offset, minor / (T(4) * speed)));
        T* nearest = nullptr;
        for (int i = outward ? 1 : 0; i < count; i += 2) {
            T& root = roots[std::size_t(i)];
            if (magnitude(root) < reach && (nearest == nullptr || magnitude(root) < magnitude(*nearest)))
                nearest = &root;
        }
        if (nearest != nullptr) *nearest = T(0);
    }
};

} // namespace rayscope
