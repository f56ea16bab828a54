#pragma once
// Eight boxes, tested against a ray at once.

#include "core/math/box.hpp"
#include "core/math/lanes.hpp"
#include "core/math/ray.hpp"

#include <array>
#include <cstdint>
#include <experimental/simd>

namespace rayscope {

/// Boxes in float, in units of the tree's own scale, and what lies in each.
struct alignas(32) Node8 {
    static constexpr std::uint32_t leaf = 1U
                                          << 31; ///< set in `child` where it is a leaf's number, not a node's

    /// Children that a walk leaves for later, at most: seven a level, of a tree as deep as BoxTreeBuilder makes it.
    static constexpr std::size_t most_ahead = std::size_t(7) * 64 + 8;

    std::array<std::array<float, 8>, 3> low, high; ///< an empty place is a box that no ray meets
    std::array<std::uint32_t, 8> child;

    Node8() : child{} {
        for (auto& axis : low) axis.fill(std::numeric_limits<float>::infinity());
        for (auto& axis : high) axis.fill(-std::numeric_limits<float>::infinity());
    }
    void set(std::size_t place, const Box<float>& box, std::uint32_t what) {
        for (int axis = 0; axis < 3; ++axis) {
            low[std::size_t(axis)][place] = box.low[axis];
            high[std::size_t(axis)][place] = box.high[axis];
        }
        child[place] = what;
    }
    [[nodiscard]] Box<float> box(std::size_t place) const {
        return {{low[0][place], low[1][place], low[2][place]},
                {high[0][place], high[1][place], high[2][place]}};
    }
};

/// One number of each.
using EightFloats = std::experimental::simd<float, std::experimental::simd_abi::deduce_t<float, 8>>;

/// A ray made ready for them: see SlabRay. Float has few digits, so the margin is wider here:
/// 4 ε · (largest coordinate of the origin + 2), where 2 is the size of the tree. That is twice what the operations of
/// `enter` round.
class Ray8 {
public:
    /// @param scale a power of two that brings the tree's coordinates below 2
    Ray8(const Ray<double>& ray, double scale, double distortion) : scale_(scale) {
        const double size = largest_component(absolute(ray.origin)) * scale + 2;
        const double margin = 4 * double(epsilon<float>) * size + 64 * epsilon<double> * distortion * size;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double inverse = 1 / ray.direction[int(axis)], origin = ray.origin[int(axis)] * scale;
            down_[axis] = ray.direction[int(axis)] < 0;
            inverse_[axis] = float(magnitude(inverse) < huge ? inverse : down_[axis] ? -huge : huge);
            // The plane that is met first moves towards the ray, the other one away from it.
            near_[axis] = float(down_[axis] ? origin - margin : origin + margin);
            far_[axis] = float(down_[axis] ? origin + margin : origin - margin);
        }
    }
    /// What to add to a SlabRay's distortion for its margin to be at least this one. What `enter` rounds in a box's favour
    /// is not in it.
    static constexpr double own_distortion = double(epsilon<float>) / epsilon<double> / 16;
    /// t in the tree's units, never rounded down.
    [[nodiscard]] float reach(double t) const { return float(t * scale_) * (1 + 2 * epsilon<float>); }

    /// Which boxes a hit with 0 ≤ t ≤ reach may lie in, a bit for each, and where the ray enters these, never rounded up.
    struct Entered {
        unsigned boxes;
        std::array<float, 8> at;
    };
    [[nodiscard, gnu::always_inline]] Entered enter(const Node8& node, float reach) const {
        using std::experimental::max, std::experimental::min;
        const auto at = [&](const std::array<float, 8>& planes, const std::array<float, 3>& origin,
                            std::size_t axis) {
            return (EightFloats(planes.data(), std::experimental::vector_aligned) - origin[axis]) *
                   inverse_[axis];
        };
        const auto nearer = [&](std::size_t axis) {
            return at(down_[axis] ? node.high[axis] : node.low[axis], near_, axis);
        };
        const auto farther = [&](std::size_t axis) {
            return at(down_[axis] ? node.low[axis] : node.high[axis], far_, axis);
        };
        const EightFloats enter = max(max(nearer(0), nearer(1)), max(nearer(2), EightFloats(0.0F))),
                          exit = min(min(farther(0), farther(1)), min(farther(2), EightFloats(reach)));
        Entered entered{bits_of(enter <= exit), {}};
        enter.copy_to(entered.at.data(), std::experimental::element_aligned);
        return entered;
    }

private:
    // Instead of the inverse of a component that is 0 or nearly: products stay in range, and a ray that a GroupRay calls
    // reliable is moved by far less than the margin.
    static constexpr double huge = 0x1p100;

    double scale_;
    std::array<bool, 3> down_;
    std::array<float, 3> inverse_, near_, far_;
};

} // namespace rayscope
