#pragma once
// The torus with major radius 1 in the plane z = 0 and minor radius r < 1. Face 0.

#include "core/generics/torus_roots.hpp"
#include "core/generics/torus_textbook.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"

namespace rayscope {

template <Numbers N> struct Torus {
    using T = ScalarOf<N>;

    T minor = T(0.25); ///< 0 < minor < 1

    static constexpr const char* name = "torus";
    static constexpr bool solid = true;

    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const {
        if constexpr (is_textbook<N>) return torus_textbook(minor, ray);
        TorusRoots<T> crossings = torus_roots(minor, ray);
        auto& [roots, count] = crossings;
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
        const T scale = rho > T(0) ? beyond_core_circle(p.x, p.y, rho) / rho : T(0);
        return {p.x * scale, p.y * scale, p.z};
    }
    [[nodiscard]] T value(const Vec3<T>& p) const {
        const T rho = sqrt(fma(p.x, p.x, p.y * p.y));
        const T w = beyond_core_circle(p.x, p.y, rho);
        return sqrt(fma(w, w, p.z * p.z)) - minor;
    }
    /// The normal curvature along d: 1 / minor around the tube, cos θ / ρ around the axis. It may vanish, on the top circle
    /// and along the asymptotic lines of the inner half; a larger one, such as the principal curvatures' larger, would
    /// claim that a graze there moves by √(2δ / h), when four roots that nearly meet move by far more.
    [[nodiscard]] T curvature(const Vec3<T>& p, const Vec3<T>& d, int /*face*/) const {
        const T rho = sqrt(fma(p.x, p.x, p.y * p.y));
        if (!(rho > T(0))) return T(0);
        const T w = beyond_core_circle(p.x, p.y, rho);
        const T outward = fma(p.x, d.x, p.y * d.y) / rho;
        const T around_axis = difference_of_products(p.x, d.y, p.y, d.x) / rho;
        const T around_tube = difference_of_products(w, d.z, p.z, outward) / minor;
        return magnitude(fma(around_tube, around_tube, around_axis * around_axis * w / rho)) / minor;
    }
    [[nodiscard]] Box<T> bounds() const {
        const T outer = T(1) + minor;
        return {Vec3<T>{-outer, -outer, -minor}, Vec3<T>{outer, outer, minor}};
    }

    template <Numbers M> [[nodiscard]] Torus<M> to() const { return {ScalarOf<M>(minor)}; }

private:
    // The ray starts on the torus: of the crossings that run its way (in or out), the nearest one is t = 0 exactly.
    // If rounding has put the start δ beside the surface, that one lies about δ / |n·d| away; at a graze, where a double
    // root moves by √ε, it may be missing, and no other one is taken for it: between the start and its crossing the ray
    // stays as close to the torus as the start does.
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
        if (nearest == nullptr) return;
        const T beside = magnitude(value(ray.at(*nearest / T(2))));
        if (beside <= fma(T(2), magnitude(value(ray.origin)), T(8) * epsilon<T>)) *nearest = T(0);
    }
};

} // namespace rayscope
