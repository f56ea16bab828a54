#pragma once
// Solid strokes and marks in view space: what a picture draws on top of the surfaces.

#include "visualizer/drawing/palette.hpp"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace rayscope::drawing {

class Mesh {
public:
    static constexpr int round = 10; ///< sides, where nothing else is asked for

    /// How round is what follows: at least 3 sides of a tube; balls and cones go with it.
    void set_sides(int sides) { sides_ = sides; }

    /// A round stroke; its radius may change from one end to the other.
    void add_tube(const Vec3d& from, const Vec3d& to, double radius_from, double radius_to, Rgb colour);
    void add_cone(const Vec3d& base, const Vec3d& tip, double radius, Rgb colour);
    void add_ball(const Vec3d& centre, double radius, Rgb colour);

    /// Triangles and quads with point normals and point colours (unsigned char, 3).
    [[nodiscard]] vtkSmartPointer<vtkPolyData> polydata() const;

private:
    int add(const Vec3d& point, const Vec3d& normal, Rgb colour);

    int sides_ = round;
    std::vector<Vec3d> points_, normals_;
    std::vector<Rgb> colours_;
    std::vector<std::array<int, 4>> quads_;
};

} // namespace rayscope::drawing
