#pragma once
// Triangles in groups: a corner and the two edges that start there.

#include "core/boxes/groups.hpp"

#include <experimental/simd>

namespace rayscope {

/// Leaves out what a line passes by far enough that no rounding could tell otherwise; a kernel answers for the rest.
/// Kept in few bytes: the corner in two floats, which hold 48 bits of it, the edges in one.
template <Scalar T> class TriangleGroups : public Groups<float, 12> {
public:
    void add(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c, std::uint32_t object) {
        const Vec3<T> ab = b - a, ac = c - a;
        const T size = largest_component(maximum_of(absolute(a), maximum_of(absolute(b), absolute(c))));
        const T edges = largest_component(maximum_of(absolute(ab), absolute(ac)));
        const Vec3<float> high = as<float>(a), low = as<float>(a - as<T>(high)), p = as<float>(ab),
                          q = as<float>(ac);
        // Outside of the range of floats, or nearly: a corner without end is left out by no ray.
        const float x = size < most && edges * most > T(1) ? high.x : infinity<float>;
        Groups::add({x, high.y, high.z, low.x, low.y, low.z, p.x, p.y, p.z, q.x, q.y, q.z}, object);
    }

    /// Calls hit(object) for each of the triangles first … last − 1, which are whole groups, that may have a crossing
    /// with 0 ≤ t ≤ reach, until it returns true.
    /// @param unit the kernel's ε; where it is larger than T's, the kernel sees the corners rounded by it
    /// @return the triangle after the one that ended it, or `last`
    template <typename OnHit>
    std::size_t each_near(const GroupRay<T>& ray, T reach, std::size_t first, std::size_t last,
                          const OnHit& hit, T unit = epsilon<T>) const {
        const Slack slack{maximum(T(2048) * unit, T(16) * T(epsilon<float>)),
                          unit > epsilon<T> ? T(4) * unit : T(0)};
        const auto near = [&](const float* numbers, std::size_t count) {
            return near_of(ray, reach, slack, numbers, count);
        };
        return this->each(first, last, near, hit);
    }

private:
    using Lanes = std::experimental::native_simd<T>;

    // Products of coordinates below this stay in range, and such coordinates in that of floats.
    static constexpr T most = T(1) / limits::power_of_half<T>(100);

    struct Slack {
        T tolerance, shift; ///< of products, and of corners
    };

    /// Of a column, as many as fit.
    struct Part {
        const float* first;
        std::size_t count;
        Lanes operator()(std::size_t column) const {
            const float* numbers = first + column * count;
            return Lanes([&](auto i) { return T(numbers[i]); });
        }
    };

    // Möller's and Trumbore's three shares and t, all times the determinant. Each is a product of three vectors, which
    // is off by a few ε of the product of their sizes (in the 1-norm: no smaller than any component's part in it), and
    // so is what a kernel asks: 2¹¹ ε of it decides nothing. The edges are off by half a float's ε each. Where the
    // determinant itself is not above that, the line runs in the triangle's plane, and a kernel is asked.
    // Negative where a triangle is left out.
    static Lanes least_of(const GroupRay<T>& ray, T reach, const Slack& slack, const Part& column) {
        using std::experimental::abs, std::experimental::min, std::experimental::max;
        constexpr T tiny = std::numeric_limits<T>::min();
        const Lanes ax = column(0) + column(3), ay = column(1) + column(4), az = column(2) + column(5),
                    bx = column(6), by = column(7), bz = column(8), cx = column(9), cy = column(10),
                    cz = column(11);
        const Lanes sx = ray.x - ax, sy = ray.y - ay, sz = ray.z - az;
        const Lanes hx = ray.dy * cz - ray.dz * cy, hy = ray.dz * cx - ray.dx * cz,
                    hz = ray.dx * cy - ray.dy * cx;
        const Lanes qx = sy * bz - sz * by, qy = sz * bx - sx * bz, qz = sx * by - sy * bx;
        const Lanes whole = bx * hx + by * hy + bz * hz;
        Lanes u = sx * hx + sy * hy + sz * hz, v = ray.dx * qx + ray.dy * qy + ray.dz * qz,
              t = cx * qx + cy * qy + cz * qz;
        const auto turned = whole < T(0);
        where(turned, u) = -u;
        where(turned, v) = -v;
        where(turned, t) = -t;
        const T direction = magnitude(ray.dx) + magnitude(ray.dy) + magnitude(ray.dz);
        const T origin = magnitude(ray.x) + magnitude(ray.y) + magnitude(ray.z);
        const Lanes b = abs(bx) + abs(by) + abs(bz), c = abs(cx) + abs(cy) + abs(cz);
        const Lanes away = abs(sx) + abs(sy) + abs(sz) + origin;
        const Lanes shift = slack.shift * away;
        const Lanes edges = slack.tolerance * b * c + shift * (b + c + shift);
        const Lanes area = abs(whole), area_slack = direction * edges + tiny;
        const Lanes side_slack = direction * away * (slack.tolerance * max(b, c) + shift) + area_slack;
        const Lanes t_slack = away * edges + tiny;
        const Lanes beside = min(min(u, v), area - u - v) + side_slack;
        const Lanes beyond = min(t, reach * (area + area_slack) - t) + t_slack;
        Lanes least = min(beside, beyond);
        where(area <= area_slack, least) = T(0);
        return least;
    }

    // Bit i: a kernel may find a crossing of triangle i in the range.
    [[gnu::noinline]] static unsigned near_of(const GroupRay<T>& ray, T reach, const Slack& slack,
                                              const float* numbers, std::size_t count) {
        if (!(ray.dd < most && magnitude(ray.x) + magnitude(ray.y) + magnitude(ray.z) < most)) return ~0U;
        reach = minimum(reach, std::numeric_limits<T>::max()); // ∞ · 0 is no number
        unsigned near = 0;
        for (std::size_t part = 0; part < group_lanes; part += Lanes::size()) {
            const auto kept = !(least_of(ray, reach, slack, {numbers + part, count}) < T(0));
            for (std::size_t i = 0; i < Lanes::size(); ++i) near |= unsigned(kept[i]) << (part + i);
        }
        return near;
    }
};

} // namespace rayscope
