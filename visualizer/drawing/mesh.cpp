#include "visualizer/drawing/mesh.hpp"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <numbers>

namespace rayscope::drawing {
namespace {

Vec3d around(const Vec3d& u, const Vec3d& v, int i, int n) {
    const double angle = 2 * std::numbers::pi * i / n;
    return u * std::cos(angle) + v * std::sin(angle);
}

/// Two unit vectors across d.
std::pair<Vec3d, Vec3d> across(const Vec3d& d) {
    const Vec3d aside = absolute(d).x < 0.8 * length(d) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
    const Vec3d u = normalized(cross(d, aside));
    return {u, normalized(cross(d, u))};
}

} // namespace

int Mesh::add(const Vec3d& point, const Vec3d& normal, Rgb colour) {
    points_.push_back(point);
    normals_.push_back(normal);
    colours_.push_back(colour);
    return int(points_.size()) - 1;
}

void Mesh::add_tube(const Vec3d& from, const Vec3d& to, double radius_from, double radius_to, Rgb colour) {
    const auto [u, v] = across(to - from);
    const int first = int(points_.size());
    for (int i = 0; i < sides_; ++i) {
        const Vec3d n = around(u, v, i, sides_);
        add(from + n * radius_from, n, colour);
        add(to + n * radius_to, n, colour);
    }
    for (int i = 0; i < sides_; ++i) {
        const int a = first + 2 * i, b = first + 2 * ((i + 1) % sides_);
        quads_.push_back({a, b, b + 1, a + 1});
    }
}

void Mesh::add_cone(const Vec3d& base, const Vec3d& tip, double radius, Rgb colour) {
    add_tube(base, tip, radius, 0, colour);
    const Vec3d backwards = normalized(base - tip);
    const auto [u, v] = across(tip - base);
    const int middle = add(base, backwards, colour);
    for (int i = 0; i < sides_; ++i) add(base + around(u, v, i, sides_) * radius, backwards, colour);
    for (int i = 0; i < sides_; ++i)
        quads_.push_back({middle, middle + 1 + (i + 1) % sides_, middle + 1 + i, middle});
}

void Mesh::add_ball(const Vec3d& centre, double radius, Rgb colour) {
    const int rings = sides_ * 4 / 5, turns = sides_ * 7 / 5;
    const int first = int(points_.size());
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i < turns; ++i) {
            const double latitude = (double(j) / rings - 0.5) * std::numbers::pi;
            const Vec3d n =
                around({1, 0, 0}, {0, 1, 0}, i, turns) * std::cos(latitude) + Vec3d{0, 0, std::sin(latitude)};
            add(centre + n * radius, n, colour);
        }
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < turns; ++i) {
            const int a = first + j * turns + i, b = first + j * turns + (i + 1) % turns;
            quads_.push_back({a, b, b + turns, a + turns});
        }
}

vtkSmartPointer<vtkPolyData> Mesh::polydata() const {
    vtkNew<vtkPoints> points;
    vtkNew<vtkFloatArray> normals;
    vtkNew<vtkUnsignedCharArray> colours;
    vtkNew<vtkCellArray> cells;
    const auto count = vtkIdType(points_.size());
    points->SetNumberOfPoints(count);
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(count);
    colours->SetNumberOfComponents(3);
    colours->SetNumberOfTuples(count);
    for (vtkIdType i = 0; i < count; ++i) {
        const auto at = std::size_t(i);
        points->SetPoint(i, &points_[at].x);
        const std::array<float, 3> n{float(normals_[at].x), float(normals_[at].y), float(normals_[at].z)};
        normals->SetTypedTuple(i, n.data());
        const std::array<unsigned char, 3> rgb{colours_[at].red, colours_[at].green, colours_[at].blue};
        colours->SetTypedTuple(i, rgb.data());
    }
    cells->AllocateExact(vtkIdType(quads_.size()), vtkIdType(4 * quads_.size()));
    for (const auto& quad : quads_) {
        const std::array<vtkIdType, 4> ids{quad[0], quad[1], quad[2], quad[3]};
        cells->InsertNextCell(quad[3] == quad[0] ? 3 : 4, ids.data());
    }
    auto data = vtkSmartPointer<vtkPolyData>::New();
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(normals);
    data->GetPointData()->SetScalars(colours);
    return data;
}

} // namespace rayscope::drawing
