#include "visualizer/drawing/tessellate.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <numbers>

namespace rayscope::drawing {
namespace {

/// A point of a face in object space and its normal there, of any length.
struct Sample {
    Vec3d point, normal;
};

class Tessellator {
public:
    Tessellator(const Mat4d& matrix, const Fineness& fineness, const Region& region)
        : matrix_(matrix),
          transform_(matrix),
          fineness_(fineness),
          region_(region),
          mirrored_(glm::determinant(Mat3<double>(matrix)) < 0) {}

    Pieces pieces;

    void operator()(const Sphere<double>&) {
        grid(fineness_.around, fineness_.around / 2, true, false, [](double u, double v) {
            const double latitude = (v - 0.5) * std::numbers::pi, ring = std::cos(latitude);
            const Vec3d p{ring * std::cos(turn(u)), ring * std::sin(turn(u)), std::sin(latitude)};
            return Sample{p, p};
        });
    }
    void operator()(const Torus<double>& torus) {
        grid(fineness_.around, fineness_.around / 2, true, true, [&](double u, double v) {
            const Vec3d out{std::cos(turn(u)), std::sin(turn(u)), 0};
            const Vec3d n = out * std::cos(turn(v)) + Vec3d{0, 0, std::sin(turn(v))};
            return Sample{out + n * torus.minor, n};
        });
    }
    void operator()(const Cylinder<double>&) {
        wall(1, 1);
        disk(-1, 1);
        disk(1, 1);
    }
    void operator()(const Cone<double>& cone) {
        wall(1, cone.top);
        disk(-1, 1);
        if (cone.top > 0) disk(1, cone.top);
    }
    void operator()(const OpenCylinder<double>&) { wall(1, 1); }
    void operator()(const OpenCone<double>& cone) { wall(1, cone.top); }
    void operator()(const Cube<double>&) {
        const int n = flat_cells();
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                grid(n, n, false, false, [&](double u, double v) {
                    Vec3d p, normal{0};
                    p[axis] = side;
                    p[(axis + 1) % 3] = side * (2 * u - 1);
                    p[(axis + 2) % 3] = 2 * v - 1;
                    normal[axis] = side;
                    return Sample{p, normal};
                });
    }
    void operator()(const Plane<double>&) {
        const Vec3d middle = transform_.point_to_object(region_.centre);
        const double cell = round_size(region_.radius / 4);
        const auto size = [&](int axis) { return length(Vec3d(matrix_[axis])); };
        const double du = cell / size(0), dv = cell / size(1);
        const double reach = 2.1 * region_.radius / cell;
        const auto first = [&](double at, double step) { return std::floor(at / step - reach); };
        const double u0 = first(middle.x, du), v0 = first(middle.y, dv);
        const int n = int(std::ceil(2 * reach)) + 1, fine = fineness_.clipped ? 4 : 1;
        grid(n * fine, n * fine, false, false, [&](double u, double v) {
            return Sample{{(u0 + u * n) * du, (v0 + v * n) * dv, 0}, {0, 0, 1}};
        });
        mark_checker(n * fine, fine, long(std::fmod(u0, 2)) + long(std::fmod(v0, 2)));
    }
    void operator()(const Polygon<double>& polygon) {
        vtkNew<vtkPolyData> outline;
        start(outline);
        vtkNew<vtkCellArray> cell;
        cell->InsertNextCell(int(polygon.vertices().size()));
        for (std::size_t i = 0; i < polygon.vertices().size(); ++i) {
            const Vec3d normal = polygon.smooth() ? polygon.normals()[i] : polygon.normal({}, 0);
            cell->InsertCellPoint(add({polygon.vertices()[i], normal}));
        }
        outline->SetPolys(cell);
        vtkNew<vtkTriangleFilter> triangles; // an outline may be concave
        triangles->SetInputData(outline);
        triangles->Update();
        pieces.emplace_back(triangles->GetOutput());
    }
    void operator()(const Mesh<double>& mesh) {
        const MeshData& data = mesh.triangles().data();
        vtkNew<vtkPolyData> piece;
        start(piece);
        vtkNew<vtkCellArray> cells;
        for (std::size_t i = 0; i < data.triangles.size();
             ++i) { // corners of their own: normals may part there
            std::array<vtkIdType, 3> ids{};
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3d& p = data.positions[data.triangles[i][k]];
                ids[k] = add({p, mesh.shading_normal(p, int(i))});
            }
            if (mirrored_) std::swap(ids[1], ids[2]);
            cells->InsertNextCell(3, ids.data());
        }
        piece->SetPolys(cells);
        pieces.emplace_back(piece);
    }

private:
    static double turn(double share) { return 2 * std::numbers::pi * share; }
    [[nodiscard]] int flat_cells() const { return fineness_.clipped ? fineness_.around / 2 : 1; }

    /// From radius `low` at z = −1 to `high` at z = 1.
    void wall(double low, double high) {
        const double slope = (low - high) / 2;
        grid(fineness_.around, fineness_.clipped ? fineness_.around / 2 : 1, true, false,
             [&](double u, double v) {
                 const double radius = low + (high - low) * v;
                 const Vec3d out{std::cos(turn(u)), std::sin(turn(u)), 0};
                 return Sample{out * radius + Vec3d{0, 0, 2 * v - 1}, out + Vec3d{0, 0, slope}};
             });
    }
    void disk(double z, double radius) {
        grid(fineness_.around, fineness_.clipped ? fineness_.around / 4 : 1, true, false,
             [&](double u, double v) {
                 const double r = z < 0 ? radius * v : radius * (1 - v);
                 return Sample{{r * std::cos(turn(u)), r * std::sin(turn(u)), z}, {0, 0, z}};
             });
    }

    /// Cells seen counter-clockwise from outside where (u, v, outward) is right-handed.
    template <typename Face> void grid(int nu, int nv, bool wrap_u, bool wrap_v, const Face& face) {
        vtkNew<vtkPolyData> piece;
        start(piece);
        const int columns = wrap_u ? nu : nu + 1, rows = wrap_v ? nv : nv + 1;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) add(face(double(i) / nu, double(j) / nv));
        vtkNew<vtkCellArray> cells;
        const auto id = [&](int i, int j) { return vtkIdType(j % rows) * columns + i % columns; };
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i) {
                std::array<vtkIdType, 4> quad{id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
                if (mirrored_) std::swap(quad[1], quad[3]);
                cells->InsertNextCell(4, quad.data());
            }
        piece->SetPolys(cells);
        pieces.emplace_back(piece);
    }

    void mark_checker(int cells, int per_square, long parity) {
        vtkNew<vtkIntArray> checker;
        checker->SetName("checker");
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i)
                checker->InsertNextValue(int(std::abs(i / per_square + j / per_square + parity) % 2));
        pieces.back()->GetCellData()->AddArray(checker);
    }

    void start(vtkPolyData* piece) {
        points_ = vtkSmartPointer<vtkPoints>::New();
        points_->SetDataTypeToDouble();
        normals_ = vtkSmartPointer<vtkFloatArray>::New();
        normals_->SetNumberOfComponents(3);
        normals_->SetName("Normals");
        piece->SetPoints(points_);
        piece->GetPointData()->SetNormals(normals_);
    }
    vtkIdType add(const Sample& sample) {
        const Vec3d p = Vec3d(matrix_ * glm::dvec4(sample.point, 1));
        const Vec3d n = transform_.normal_to_world(sample.normal);
        normals_->InsertNextTuple3(n.x, n.y, n.z);
        return points_->InsertNextPoint(p.x, p.y, p.z);
    }

    Mat4d matrix_;
    Transform<double> transform_;
    Fineness fineness_;
    const Region& region_;
    bool mirrored_;
    vtkSmartPointer<vtkPoints> points_;
    vtkSmartPointer<vtkFloatArray> normals_;
};

} // namespace

double round_size(double size) {
    const double power = std::pow(10, std::floor(std::log10(size)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (size <= factor * power * 1.01) return factor * power;
    return 10 * power;
}

Pieces tessellate(const Generic<double>& shape, const Mat4d& matrix, const Fineness& fineness,
                  const Region& region) {
    Tessellator tessellator(matrix, fineness, region);
    std::visit(tessellator, shape);
    return std::move(tessellator.pieces);
}

} // namespace rayscope::drawing
