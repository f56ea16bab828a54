#pragma once
// Whether a line passes through a flat outline: the count that leaves no gap between neighbours.

#include "core/math/ray.hpp"

#include <type_traits>

namespace rayscope {

/// Space, sheared so that a ray becomes the z axis through the origin. What an edge answers depends on its two ends
/// alone and turns its sign with their order, so outlines that share an edge never both miss a ray between them (Woop,
/// Benthin, Wald, Watertight Ray/Triangle Intersection, JCGT 2(1), 2013). Where rounding could have turned an answer
/// it is asked again in a wider type: a sliver thinner than the rounding of its corners is still there.
template <Scalar T> class OutlineView {
public:
    explicit OutlineView(const Ray<T>& ray) : ray_(ray) {
        const Vec3<T> size = absolute(ray.direction);
        z_ = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const Vec3<T> along = turned(ray.direction);
        shear_x_ = along.x / along.z;
        shear_y_ = along.y / along.z;
    }

    struct Corner {
        const Vec3<T>* vertex;
        T x, y, error; ///< of x and of y, at most
        bool above;    ///< y > 0
    };
    [[nodiscard]] Corner corner(const Vec3<T>& vertex) const {
        Corner corner = seen(vertex);
        corner.above = corner.y > T(0);
        if constexpr (has_wider)
            if (!(magnitude(corner.y) > corner.error)) corner.above = is_above_in_wider(vertex);
        return corner;
    }

    /// Whether the edge crosses the half line y = 0, x > 0.
    [[nodiscard]] bool crosses(const Corner& a, const Corner& b) const {
        if (a.above == b.above) return false;
        T side = difference_of_products(a.x, b.y, b.x, a.y);
        if constexpr (has_wider) {
            const auto reach = [](const Corner& c) { return magnitude(c.x) + magnitude(c.y) + c.error; };
            const T error = a.error * reach(b) + b.error * reach(a) + T(2) * epsilon<T> * magnitude(side);
            if (!(magnitude(side) > error)) return crosses_in_wider(a, b);
        }
        return b.above ? side > T(0) : side < T(0);
    }
    /// The same, signed by the way in which it crosses: the sum over an outline is how often it runs around the ray,
    /// counter-clockwise as seen from above.
    [[nodiscard]] int turn(const Corner& a, const Corner& b) const {
        return crosses(a, b) ? (b.above ? 1 : -1) : 0;
    }
    /// Whether the ray runs upwards, away from who looks from above.
    [[nodiscard]] bool runs_up() const { return ray_.direction[z_] > T(0); }
    /// t of a vertex's foot on the ray.
    [[nodiscard]] T depth(const Vec3<T>& vertex) const {
        return (vertex[z_] - ray_.origin[z_]) / ray_.direction[z_];
    }

private:
    template <Scalar> friend class OutlineView;

    using Wider = std::conditional_t<std::is_same_v<T, float>, double, Float128>;
    static constexpr bool has_wider = !std::is_same_v<T, Wider>;

    // Functions of their own, lest the compiler makes the ray wider before it is needed.
    [[nodiscard, gnu::noinline, gnu::cold]] bool is_above_in_wider(const Vec3<T>& vertex) const {
        return OutlineView<Wider>(as<Wider>(ray_)).seen(as<Wider>(vertex)).y > Wider(0);
    }
    [[nodiscard, gnu::noinline, gnu::cold]] bool crosses_in_wider(const Corner& a, const Corner& b) const {
        const OutlineView<Wider> view(as<Wider>(ray_));
        const auto wa = view.seen(as<Wider>(*a.vertex)), wb = view.seen(as<Wider>(*b.vertex));
        const Wider side = difference_of_products(wa.x, wb.y, wb.x, wa.y);
        return b.above ? side > Wider(0) : side < Wider(0);
    }

    /// The axis that is nearest to the ray comes last.
    [[nodiscard]] Vec3<T> turned(const Vec3<T>& v) const {
        if (z_ == 2) return v;
        return z_ == 0 ? Vec3<T>{v.y, v.z, v.x} : Vec3<T>{v.z, v.x, v.y};
    }
    // Five roundings of at most half an ε, as neither shear is above 1.
    [[nodiscard]] Corner seen(const Vec3<T>& vertex) const {
        const Vec3<T> v = turned(vertex - ray_.origin);
        const T size = maximum(magnitude(v.x), magnitude(v.y)) + magnitude(v.z);
        return {&vertex, fma(-shear_x_, v.z, v.x), fma(-shear_y_, v.z, v.y), T(2) * epsilon<T> * size, false};
    }

    Ray<T> ray_;
    int z_;
    T shear_x_, shear_y_;
};

} // namespace rayscope
