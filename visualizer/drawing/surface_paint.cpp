#include "visualizer/drawing/surface_paint.hpp"

#include "visualizer/drawing/merging.hpp"
#include "visualizer/drawing/scene_objects.hpp"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkContourFilter.h>
#include <vtkDataArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace rayscope::drawing {
namespace {

struct Look {
    Rgb colour, outline;
    double opacity;
};

Look look_of(const SceneMaterial& material, bool hit) {
    const bool glass = largest_component(material.transmission) > 0;
    const bool mirror = largest_component(material.reflection) > 0.3;
    const Rgb own = on_screen(material.diffuse + material.ambient * 0.5);
    Look look{mixed(own, Rgb{0xB0, 0xB4, 0xBA}, 0.35), {}, 0.36};
    if (glass)
        look = {mixed(Rgb{0x7F, 0xB2, 0xDD}, own, 0.25), {}, 0.2};
    else if (mirror)
        look = {mixed(Rgb{0x9C, 0xA8, 0xB8}, own, 0.4), {}, 0.34};
    look.outline = mixed(mixed(look.colour, Rgb{0x30, 0x38, 0x44}, 0.72), sky, hit ? 0.0 : 0.55);
    if (!hit) look.opacity *= 0.35;
    return look;
}

/// Collects pieces into one data set, so that hundreds of objects are drawn at once.
class Collection {
public:
    explicit Collection(int components) : components_(components) {
        colours_->SetNumberOfComponents(components);
        normals_->SetNumberOfComponents(3);
    }

    vtkIdType add_point(const Vec3d& p, const double* normal) {
        if (normal != nullptr) normals_->InsertNextTuple(normal);
        return points_->InsertNextPoint(&p.x);
    }
    void add_colour(Rgb c, double opacity) {
        const std::array<unsigned char, 4> rgba{c.red, c.green, c.blue,
                                                static_cast<unsigned char>(std::lround(opacity * 255))};
        colours_->InsertNextTypedTuple(rgba.data());
    }
    void add_cell(vtkIdType count, const vtkIdType* ids, vtkIdType offset) {
        cells_->InsertNextCell(int(count));
        for (vtkIdType i = 0; i < count; ++i) cells_->InsertCellPoint(ids[i] + offset);
    }
    [[nodiscard]] vtkIdType size() const { return points_->GetNumberOfPoints(); }

    enum class Kind : std::uint8_t { faces, lines };
    [[nodiscard]] vtkSmartPointer<vtkPolyData> result(Kind kind, bool colours_of_points) const {
        auto data = vtkSmartPointer<vtkPolyData>::New();
        data->SetPoints(points_);
        if (kind == Kind::faces)
            data->SetPolys(cells_);
        else
            data->SetLines(cells_);
        if (normals_->GetNumberOfTuples() > 0) data->GetPointData()->SetNormals(normals_);
        if (colours_of_points)
            data->GetPointData()->SetScalars(colours_);
        else
            data->GetCellData()->SetScalars(colours_);
        return data;
    }

private:
    int components_;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkFloatArray> normals_;
    vtkNew<vtkUnsignedCharArray> colours_;
    vtkNew<vtkCellArray> cells_;
};

template <typename Visit> void each_cell(vtkCellArray* cells, const Visit& visit) {
    const auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell()) {
        vtkIdType count = 0;
        const vtkIdType* ids = nullptr;
        iterator->GetCurrentCell(count, ids);
        visit(iterator->GetCurrentCellId(), count, ids);
    }
}

/// A copy whose points lie in view space.
vtkSmartPointer<vtkPolyData> moved(vtkPolyData* piece, const View& view) {
    vtkNew<vtkPoints> points;
    points->SetNumberOfPoints(piece->GetNumberOfPoints());
    for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
        const Vec3d p = view.to_view(point_of(piece, i));
        points->SetPoint(i, p.x, p.y, p.z);
    }
    auto copy = vtkSmartPointer<vtkPolyData>::New();
    copy->ShallowCopy(piece);
    copy->SetPoints(points);
    return copy;
}

class Painting {
public:
    explicit Painting(const View& view) : view_(view) {}

    void add_faces(vtkPolyData* piece, const Look& look, bool room) {
        const vtkIdType offset = faces_.size();
        vtkDataArray* normals = piece->GetPointData()->GetNormals();
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
            const Vec3d p = point_of(piece, i);
            std::array<double, 3> n{};
            normals->GetTuple(i, n.data());
            // Glass is darker where one looks along its surface, as its rim is.
            const double facing = std::abs(dot(Vec3d{n[0], n[1], n[2]}, normalized(view_.position() - p)));
            faces_.add_point(p, n.data());
            faces_.add_colour(look.colour,
                              std::min(look.opacity * (1 + 0.9 * (1 - facing) * (1 - facing)), 0.95));
        }
        each_cell(piece->GetPolys(), [&](vtkIdType, vtkIdType count, const vtkIdType* ids) {
            if (!room || !stands_before(piece, ids[0])) faces_.add_cell(count, ids, offset);
        });
    }

    void add_floor(vtkPolyData* piece, const Look& look) {
        const vtkIdType offset = floors_.size();
        const bool before = piece->GetNumberOfPoints() > 0 && seen_from_behind(piece);
        vtkDataArray* checker = piece->GetCellData()->GetArray("checker");
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
            floors_.add_point(point_of(piece, i), nullptr);
        each_cell(piece->GetPolys(), [&](vtkIdType cell, vtkIdType count, const vtkIdType* ids) {
            Vec3d middle{0};
            for (vtkIdType i = 0; i < count; ++i) middle += point_of(piece, ids[i]) / double(count);
            const double fade = std::clamp((2.0 - length(middle)) / 0.8, 0.0, 1.0);
            if (!(fade > 0)) return;
            const bool dark = checker != nullptr && checker->GetTuple1(cell) > 0;
            const Rgb tint = mixed(look.colour, Rgb{0xDD, 0xE1, 0xE8}, 0.75);
            floors_.add_cell(count, ids, offset);
            floors_.add_colour(dark ? mixed(tint, Rgb{0xA8, 0xB0, 0xBE}, 0.28) : mixed(tint, paper, 0.55),
                               (before ? 0.12 : 0.8) * fade);
        });
    }

    void add_outline(vtkPolyData* piece, const Look& look, bool room) {
        vtkNew<vtkFeatureEdges> rims;
        rims->SetInputData(piece);
        rims->BoundaryEdgesOn();
        rims->FeatureEdgesOff();
        rims->NonManifoldEdgesOff();
        rims->ManifoldEdgesOff();
        rims->ColoringOff();
        rims->SetLocator(merging(piece->GetNumberOfPoints()));
        rims->Update();
        add_lines(rims->GetOutput(), look.outline);
        if (!room) add_lines(silhouette(piece), look.outline);
    }

    [[nodiscard]] PaintedSurfaces result() const {
        return {faces_.result(Collection::Kind::faces, true), floors_.result(Collection::Kind::faces, false),
                outlines_.result(Collection::Kind::lines, false)};
    }

private:
    /// The near walls of a room would hide what is in it: those whose outer side the camera sees.
    [[nodiscard]] bool stands_before(vtkPolyData* piece, vtkIdType id) const {
        std::array<double, 3> n{};
        piece->GetPointData()->GetNormals()->GetTuple(id, n.data());
        const Vec3d normal{n[0], n[1], n[2]}, p = point_of(piece, id);
        const Vec3d outward = dot(normal, p) < 0 ? -normal : normal;
        return dot(outward, view_.position() - p) > 0;
    }

    /// The camera stands in the half space itself.
    [[nodiscard]] bool seen_from_behind(vtkPolyData* plane) const {
        std::array<double, 3> n{};
        plane->GetPointData()->GetNormals()->GetTuple(0, n.data());
        return dot(Vec3d{n[0], n[1], n[2]}, view_.position() - point_of(plane, 0)) < 0;
    }

    /// Where the surface turns away: smooth, since it runs across cells by their normals.
    [[nodiscard]] vtkSmartPointer<vtkPolyData> silhouette(vtkPolyData* piece) const {
        vtkNew<vtkFloatArray> facing;
        vtkDataArray* normals = piece->GetPointData()->GetNormals();
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
            std::array<double, 3> n{};
            normals->GetTuple(i, n.data());
            facing->InsertNextValue(
                float(dot(Vec3d{n[0], n[1], n[2]}, view_.position() - point_of(piece, i))));
        }
        vtkNew<vtkPolyData> input;
        input->ShallowCopy(piece);
        input->GetPointData()->SetScalars(facing);
        vtkNew<vtkContourFilter> contour;
        contour->SetInputData(input);
        contour->SetValue(0, 0);
        contour->ComputeScalarsOff();
        contour->Update();
        return contour->GetOutput();
    }

    void add_lines(vtkPolyData* lines, Rgb colour) {
        const vtkIdType offset = outlines_.size();
        for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i)
            outlines_.add_point(point_of(lines, i), nullptr);
        each_cell(lines->GetLines(), [&](vtkIdType, vtkIdType count, const vtkIdType* ids) {
            outlines_.add_cell(count, ids, offset);
            outlines_.add_colour(colour, 1);
        });
    }

    const View& view_;
    Collection faces_{4}, floors_{4}, outlines_{3};
};

} // namespace

PaintedSurfaces paint_surfaces(const Surfaces& surfaces, const Scene& scene, const View& view) {
    Painting painting(view);
    for (const Surface& surface : surfaces.shown) {
        Look look = look_of(material_of(scene, surface.drawn), surface.hit);
        if (surface.large) look.opacity *= 0.4;
        for (const auto& piece : surface.pieces) {
            const auto in_view = moved(piece, view);
            if (surface.flat) {
                painting.add_floor(in_view, look);
                continue;
            }
            painting.add_faces(in_view, look, surface.room);
            painting.add_outline(in_view, look, surface.room);
        }
    }
    return painting.result();
}

} // namespace rayscope::drawing
