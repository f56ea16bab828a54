#pragma once
// A cell that is cut into eight, and how a ray goes through the parts.

#include "core/boxes/slab_ray.hpp"
#include "core/math/lanes.hpp"
#include "core/octree/statistics.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <experimental/simd>

namespace rayscope {

/// The region of a node or leaf: a cube. Its parts' corners follow from it by the same additions wherever they are asked
/// for, so that all agree in every bit.
struct Cell {
    Vec3d low; // not set here: a walk has many of them
    double edge;

    /// Part 4z + 2y + x is the upper half along the axes of its bits.
    [[nodiscard]] Cell part(unsigned child) const {
        const double half = edge / 2;
        return {low + half * corners[child], half};
    }
    [[nodiscard]] Box<double> box() const { return {low, low + Vec3d{edge}}; }

private:
    // A table: no branch can foresee which part is next.
    static constexpr std::array<Vec3d, 8> corners{
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}}};
};

/// One line of the cache: for each part the extent of what lies in it, in steps of the cell's edge. The parts' borders
/// are whole steps. Parts that are divided again are neighbours among the nodes, the others among the leaves.
struct alignas(64) OctreeNode {
    static constexpr int steps = 254;

    std::array<std::array<std::uint8_t, 8>, 6> planes{}; ///< lower x, y, z, then upper x, y, z
    std::uint32_t first_node = 0, first_leaf = 0;
    std::uint8_t divided = 0, leaves = 0; ///< bit i: part i; in neither: nothing is in it

    [[nodiscard]] std::uint32_t node_of(unsigned child) const { return first_node + before(divided, child); }
    [[nodiscard]] std::uint32_t leaf_of(unsigned child) const { return first_leaf + before(leaves, child); }

    /// @param box of what lies in the part, within the cell; rounded outward
    void set_extent(unsigned child, const Cell& cell, const Box<double>& box) {
        const double per_step = steps / cell.edge;
        for (int axis = 0; axis < 3; ++axis) {
            const auto k = std::size_t(axis);
            const bool upper = (child >> k & 1U) != 0;
            const double least = upper ? steps / 2 : 0, most = upper ? steps : steps / 2;
            const double from = std::floor((box.low[axis] - cell.low[axis]) * per_step),
                         to = std::ceil((box.high[axis] - cell.low[axis]) * per_step);
            planes[k][child] = std::uint8_t(minimum(maximum(from, least), most));
            planes[k + 3][child] = std::uint8_t(minimum(maximum(to, least), most));
        }
    }

private:
    [[nodiscard]] static std::uint32_t before(std::uint8_t mask, unsigned child) {
        return std::uint32_t(std::popcount(mask & ((1U << child) - 1U)));
    }
};
static_assert(sizeof(OctreeNode) == 64);

/// A ray made ready for them.
class OctreeRay {
public:
    explicit OctreeRay(const SlabRay<double>& slabs) : inverse_(slabs.inverse()) {
        for (int axis = 0; axis < 3; ++axis) {
            const bool down = inverse_[axis] < 0;
            const double margin = down ? -slabs.margin() : slabs.margin();
            mirror_ |= unsigned(down) << unsigned(axis);
            near_[std::size_t(axis)] = std::size_t(down ? axis + 3 : axis);
            // The plane that is met first moves towards the ray, the other one away from it.
            nearer_[axis] = slabs.origin()[axis] + margin;
            farther_[axis] = slabs.origin()[axis] - margin;
        }
    }

    /// Part i ^ mirror() is met no later than part (i + 1) ^ mirror(), if it is met at all.
    [[nodiscard]] unsigned mirror() const { return mirror_; }
    /// Bit i of the result is bit i ^ mirror().
    [[nodiscard]] unsigned in_ray_order(unsigned mask) const {
        if ((mirror_ & 1U) != 0) mask = (mask & 0x55U) << 1U | (mask >> 1U & 0x55U);
        if ((mirror_ & 2U) != 0) mask = (mask & 0x33U) << 2U | (mask >> 2U & 0x33U);
        if ((mirror_ & 4U) != 0) mask = (mask & 0x0fU) << 4U | mask >> 4U;
        return mask;
    }

    /// @param enter takes up, never rounded up, where the ray enters the extent of each part, or 0
    /// @return bit i: a hit with 0 ≤ t ≤ reach may lie in part i
    [[nodiscard, gnu::always_inline]] unsigned meet(const OctreeNode& node, const Cell& cell, double reach,
                                                    std::array<double, 8>& enter) const {
        const double step = cell.edge * (1.0 / OctreeNode::steps);
        const Vec3d per_step = step * inverse_, first = (cell.low - nearer_) * inverse_,
                    last = (cell.low - farther_) * inverse_;
        unsigned met = 0;
        for (std::size_t half = 0; half < halves; ++half) {
            const auto at = [&](std::size_t plane, const Vec3d& t, std::size_t axis) {
                return numbers_of(node.planes[plane], half) * per_step[int(axis)] + t[int(axis)];
            };
            const Lanes from = std::experimental::max(
                            std::experimental::max(at(near_[0], first, 0), at(near_[1], first, 1)),
                            std::experimental::max(at(near_[2], first, 2), Lanes(0))),
                        to = std::experimental::min(
                            std::experimental::min(at(3 - near_[0], last, 0), at(5 - near_[1], last, 1)),
                            std::experimental::min(at(7 - near_[2], last, 2), Lanes(reach)));
            from.copy_to(&enter[half * Lanes::size()], std::experimental::element_aligned);
            met |= bits_of(from <= to) << (half * Lanes::size());
        }
        return met;
    }

private:
    using Lanes = std::experimental::simd<
        double, std::experimental::simd_abi::deduce_t<
                    double, std::min<std::size_t>(8, std::experimental::native_simd<double>::size())>>;
    using Words = std::experimental::rebind_simd_t<std::uint64_t, Lanes>;
    static constexpr std::size_t halves = 8 / Lanes::size();

    /// Bytes as numbers. Compilers convert them one by one; behind the exponent of 2⁵² they are numbers already.
    static Lanes numbers_of(const std::array<std::uint8_t, 8>& bytes, std::size_t half) {
        const Words word = std::bit_cast<std::uint64_t>(bytes);
        const Words places([&](auto i) { return 8 * (i + half * Lanes::size()); });
        return std::bit_cast<Lanes>((word >> places & 255U) | std::bit_cast<std::uint64_t>(0x1p52)) - 0x1p52;
    }

    unsigned mirror_ = 0;
    std::array<std::size_t, 3> near_{}; // which of a node's planes is met first
    Vec3d inverse_, nearer_, farther_;
};

} // namespace rayscope
