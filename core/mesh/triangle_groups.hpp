#pragma once
// Triangles in groups: a corner and the two edges that start there.

#include "core/boxes/groups.hpp"
#include "core/math/lanes.hpp"

#include <experimental/simd>

namespace rayscope {

/// Leaves out what a line passes by far enough that no rounding could tell otherwise; a kernel answers for the rest.
class TriangleGroups : public Groups<9> {
public:
    /// @param scale see tree_scale
    void add(const Vec3d& a, const Vec3d& b, const Vec3d& c, std::uint32_t object, double scale) {
        const auto o = as<float>(a * scale), p = as<float>((b - a) * scale), q = as<float>((c - a) * scale);
        Groups::add({o.x, o.y, o.z, p.x, p.y, p.z, q.x, q.y, q.z}, object);
    }

    /// Calls hit(object) for each of the triangles first … last − 1, which are whole groups, that may have a crossing
    /// with 0 ≤ t ≤ reach, until it returns true.
    /// @param unit the kernel's ε; where it is larger than a double's, the kernel sees the corners rounded by it
    /// @return the triangle after the one that ended it, or `last`
    template <typename OnHit>
    std::size_t each_near(const GroupRay& ray, double reach, std::size_t first, std::size_t last,
                          const OnHit& hit, double unit = epsilon<double>) const {
        const Slack slack{float(maximum(2048 * unit, 24 * double(epsilon<float>))),
                          unit > epsilon<double> ? float(4 * unit) : 0.0F};
        const auto near = [&, limit = ray.reach(reach)](const float* numbers, std::size_t count) {
            return near_of(ray, limit, slack, numbers, count);
        };
        return this->each(first, last, near, hit);
    }

private:
    using Lanes = std::experimental::native_simd<float>;

    struct Slack {
        float tolerance, shift; ///< of products, and of corners
    };

    // Möller's and Trumbore's three shares and t, all times the determinant. Each is a product of three vectors, which
    // is off by at most 6 ε of the product of their sizes (in the 1-norm: no smaller than any component's part in it),
    // edges and direction being rounded too, and what a kernel asks by far less. Corner and origin are off by 2 ε of the
    // sizes of both, which is as much again: 24 ε of the products decide nothing. Where the determinant itself is not
    // above that, the line runs in the triangle's plane, and a kernel is asked.
    // Negative where a triangle is left out.
    static Lanes least_of(const GroupRay& ray, float reach, const Slack& slack, const float* first,
                          std::size_t count) {
        using std::experimental::abs, std::experimental::min, std::experimental::max;
        constexpr float tiny = std::numeric_limits<float>::min();
        const auto column = [&](std::size_t which) {
            return Lanes(first + which * count, std::experimental::element_aligned);
        };
        const Lanes sx = ray.x - column(0), sy = ray.y - column(1), sz = ray.z - column(2), bx = column(3),
                    by = column(4), bz = column(5), cx = column(6), cy = column(7), cz = column(8);
        const Lanes hx = ray.dy * cz - ray.dz * cy, hy = ray.dz * cx - ray.dx * cz,
                    hz = ray.dx * cy - ray.dy * cx;
        const Lanes qx = sy * bz - sz * by, qy = sz * bx - sx * bz, qz = sx * by - sy * bx;
        const Lanes whole = bx * hx + by * hy + bz * hz;
        Lanes u = sx * hx + sy * hy + sz * hz, v = ray.dx * qx + ray.dy * qy + ray.dz * qz,
              t = cx * qx + cy * qy + cz * qz;
        const auto turned = whole < 0.0F;
        where(turned, u) = -u;
        where(turned, v) = -v;
        where(turned, t) = -t;
        const float direction = magnitude(ray.dx) + magnitude(ray.dy) + magnitude(ray.dz);
        const float origin = magnitude(ray.x) + magnitude(ray.y) + magnitude(ray.z);
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
        where(area <= area_slack, least) = 0.0F;
        return least;
    }

    // Bit i: a kernel may find a crossing of triangle i in the range.
    [[gnu::noinline]] static unsigned near_of(const GroupRay& ray, float reach, const Slack& slack,
                                              const float* numbers, std::size_t count) {
        unsigned near = 0;
        for (std::size_t part = 0; part < group_lanes; part += Lanes::size()) {
            const auto kept = !(least_of(ray, reach, slack, numbers + part, count) < 0.0F);
            near |= bits_of(kept) << part;
        }
        return near;
    }
};

} // namespace rayscope
