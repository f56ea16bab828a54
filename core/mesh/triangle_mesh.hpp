#pragma once
// Triangles and the tree of boxes that finds them: one in memory for all numbers and for all solids that show it.

#include "core/boxes/walk8.hpp"
#include "core/mesh/closed.hpp"
#include "core/mesh/triangle_groups.hpp"

#include <functional>

namespace rayscope {

/// Immutable. About 100 bytes a triangle where six triangles share a vertex.
class TriangleMesh {
public:
    /// @param data at least one triangle, at most most_triangles. A closed mesh that is inside out is turned.
    explicit TriangleMesh(MeshData data);

    static constexpr std::size_t most_triangles = std::size_t(1) << 27U;

    [[nodiscard]] const MeshData& data() const { return data_; }
    [[nodiscard]] std::size_t size() const { return data_.triangles.size(); }
    [[nodiscard]] const Box<double>& bounds() const { return bounds_; }
    /// A power of two that brings all coordinates below 2.
    [[nodiscard]] double scale() const { return scale_; }
    /// Where it is open; nothing if it encloses a volume.
    [[nodiscard]] const std::optional<Hole>& hole() const { return hole_; }
    [[nodiscard]] std::size_t bytes() const;

    /// Calls visit(triangle) for all that the half line t ≥ 0 may meet at a t ≤ reach(), roughly from the nearest on.
    /// @param unit ε of whoever tests them
    template <typename Reach, typename Visit>
    void along(const Ray<double>& ray, double unit, const Reach& reach, const Visit& visit) const {
        // Where a matrix makes the ray's direction very long or short, floats would have no room for it.
        if (const double size = largest_component(absolute(ray.direction));
            (size < shortest || size > 1 / shortest) && size > 0 && is_finite(size)) {
            const double unit_size = std::exp2(std::ilogb(size));
            along({ray.origin, ray.direction / unit_size}, unit,
                  std::function<double()>([&] { return reach() * unit_size; }), visit);
            return;
        }
        const GroupRay group_ray(ray, scale_);
        if (!group_ray.reliable()) {
            if (!may_meet_from_afar(ray)) return;
            for (std::uint32_t i = 0; i < size(); ++i) visit(i);
            return;
        }
        const Ray8 ray8(ray, scale_, 1);
        const auto test = [&](std::uint32_t triangle) {
            visit(triangle);
            return false;
        };
        std::uint64_t visited = 0;
        walk8(
            nodes_, ray8, [&] { return ray8.reach(reach()); }, visited,
            [&](std::uint32_t leaf) {
                const std::size_t first = leaf >> count_bits, last = first + 1 + (leaf & count_mask);
                groups_.each_near(group_ray, reach(), first, last, test, unit);
                return false;
            });
    }

    /// Whether a triangle's box meets this one.
    [[nodiscard]] bool any_in(const Box<double>& box) const;

    /// From a point to the nearest triangle.
    [[nodiscard]] double distance(const Vec3d& p) const;

private:
    static constexpr double shortest = limits::power_of_half<double>(40);
    // A leaf's number: its first place in groups_, and how many follow it.
    static constexpr std::uint32_t count_bits = 4, count_mask = 15;

    [[nodiscard]] bool may_meet_from_afar(const Ray<double>& ray) const;

    MeshData data_;
    Box<double> bounds_;
    std::optional<Hole> hole_;
    double scale_ = 1;
    std::vector<Node8> nodes_;
    TriangleGroups groups_; // one a leaf
};

} // namespace rayscope
