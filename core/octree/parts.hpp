#pragma once
// Which objects have a surface in which of the eight parts of a cell.

#include "core/octree/node.hpp"
#include "core/stage/cover.hpp"

#include <array>
#include <span>
#include <vector>

namespace rayscope {

/// Exact for solids whose matrix keeps boxes boxes, up to a margin: not only the objects' boxes are asked, so that the
/// corners of a ball's box list nothing.
template <Numbers N> class OctreeParts {
public:
    struct Part {
        std::vector<std::uint32_t> objects;
        Box<double> extent; ///< of what they have in it, widened by the margin
        double cost = 0;    ///< of a ray's tests of them: cost_of, added up
    };

    explicit OctreeParts(const World<N>& world) : world_(world) {}

    /// @param margin by which parts overlap, and extents are widened
    void prepare(std::span<const std::uint32_t> objects, double margin);

    /// Fills parts().
    void share(std::span<const std::uint32_t> objects, const Cell& cell);
    [[nodiscard]] const std::array<Part, 8>& parts() const { return parts_; }

    /// What testing an object costs: see test_cost_in_leaf.
    [[nodiscard]] double cost_of(std::uint32_t object) const { return double(brief_[object].cost); }
    [[nodiscard]] Box<double> bounds_of(std::uint32_t object) const;

private:
    /// What is asked again on every level, side by side.
    struct Brief {
        Vec3d centre{0};
        double radius = -1; ///< of a ball; others have none
        float cost = 0;
    };

    void share_ball(const Brief& ball, std::uint32_t object, const Cell& cell);
    void add(unsigned child, std::uint32_t object, const Box<double>& bounds, double cost);

    const World<N>& world_;
    double margin_ = 0;
    std::vector<Brief> brief_; // by object
    std::array<Part, 8> parts_;
    std::vector<Cover> covers_;
};

extern template class OctreeParts<double>;

} // namespace rayscope
