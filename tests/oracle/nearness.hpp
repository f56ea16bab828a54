#pragma once
// Where a point of a ray lies in a leaf, apart from the core and in 113 bits: for what the case files don't
// state.

#include "core/cases/exact_cases.hpp"

namespace rayscope::test {

/// The point of a ray at t in the object space of a leaf.
class PointInLeaf {
public:
    PointInLeaf(const CaseLeaf& leaf, const Ray<double>& ray, long double t, double epsilon);

    /// True if inputs that are off by 64 ε can put the point on the leaf's surface.
    [[nodiscard]] bool is_near_surface() const;
    /// The same for one face, in the oracle's words.
    [[nodiscard]] bool is_near(const std::string& face) const;
    /// Unit outward world normal of that face here.
    [[nodiscard]] Vec3d normal(const std::string& face) const;

private:
    using Vector = glm::vec<3, long double>;

    struct Face {
        std::string name;
        long double distance; // positive outside, about a length
        Vector normal;
    };
    [[nodiscard]] std::vector<Face> faces() const;
    [[nodiscard]] Face face(const std::string& name) const;

    Generic<double> shape_;
    glm::mat<3, 3, long double> inverse_; // inverse_[i] is row i
    Vector point_;
    long double reach_; // how far 64 ε can move the point
};

} // namespace rayscope::test
