#include "visualizer/drawing/trace_geometry.hpp"

#include "visualizer/drawing/palette.hpp"
#include "visualizer/drawing/ray_path.hpp"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include <algorithm>

namespace rayscope::drawing {
namespace {

/// A named column of numbers or strings, one entry for each line or vertex.
template <typename Array> struct Column {
    vtkNew<Array> array;
    explicit Column(const char* name, int components = 1) {
        array->SetName(name);
        array->SetNumberOfComponents(components);
    }
};

struct Lines {
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;

    Lines() { points->SetDataTypeToDouble(); }
    vtkIdType point(const Vec3d& p) { return points->InsertNextPoint(p.x, p.y, p.z); }
    void line(const Vec3d& from, const Vec3d& to) {
        const std::array<vtkIdType, 2> ids{point(from), point(to)};
        cells->InsertNextCell(2, ids.data());
    }
    void vertex(const Vec3d& p) {
        const vtkIdType id = point(p);
        cells->InsertNextCell(1, &id);
    }
};

} // namespace

vtkSmartPointer<vtkPolyData> rays_polydata(const Trace& trace, double open_length) {
    Lines lines;
    Column<vtkIntArray> id("ray_id"), parent("parent_id"), step("step"), depth("depth"), kind("kind"),
        open("open"), blocked("blocked");
    Column<vtkStringArray> kinds("kind_name"), objects("object_name");
    Column<vtkDoubleArray> t_hit("t_hit"), share("weight"), direction("direction", 3);
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const TracedRay& ray = trace.rays[i];
        const RaySpawned& start = ray.start();
        const auto* hit = ray.find<BoundaryChosen>();
        const RayEnd end = drawn_end(ray, open_length);
        lines.line(start.origin, end.point);
        id.array->InsertNextValue(int(i));
        parent.array->InsertNextValue(ray.parent);
        step.array->InsertNextValue(int(i));
        depth.array->InsertNextValue(start.depth);
        kind.array->InsertNextValue(int(start.kind));
        open.array->InsertNextValue(end.open ? 1 : 0);
        blocked.array->InsertNextValue(is_blocked(ray) ? 1 : 0);
        kinds.array->InsertNextValue(kind_name(start.kind));
        objects.array->InsertNextValue(target_name(trace, ray));
        t_hit.array->InsertNextValue(hit != nullptr ? hit->boundary.t : not_a_number);
        share.array->InsertNextValue(weight(ray));
        direction.array->InsertNextTuple3(start.direction.x, start.direction.y, start.direction.z);
    }
    lines.data->SetPoints(lines.points);
    lines.data->SetLines(lines.cells);
    for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{
             id.array, parent.array, step.array, depth.array, kind.array, kinds.array, objects.array,
             t_hit.array, share.array, direction.array, open.array, blocked.array})
        lines.data->GetCellData()->AddArray(column);
    return lines.data;
}

vtkSmartPointer<vtkPolyData> hits_polydata(const Trace& trace) {
    Lines lines;
    Column<vtkIntArray> id("ray_id"), step("step");
    Column<vtkStringArray> objects("object_name");
    Column<vtkDoubleArray> t_hit("t_hit"), bound("error_bound"), normals("Normals", 3);
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const auto* hit = trace.rays[i].find<BoundaryChosen>();
        if (hit == nullptr) continue;
        lines.vertex(hit->point);
        id.array->InsertNextValue(int(i));
        step.array->InsertNextValue(int(i));
        objects.array->InsertNextValue(object_name(trace, hit->object));
        t_hit.array->InsertNextValue(hit->boundary.t);
        bound.array->InsertNextValue(hit->error_bound);
        normals.array->InsertNextTuple3(hit->normal.x, hit->normal.y, hit->normal.z);
    }
    lines.data->SetPoints(lines.points);
    lines.data->SetVerts(lines.cells);
    for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{
             id.array, step.array, objects.array, t_hit.array, bound.array})
        lines.data->GetPointData()->AddArray(column);
    lines.data->GetPointData()->SetNormals(normals.array);
    return lines.data;
}

std::string node_label(const Trace& trace, Id object, Id node) {
    if (object < 0 || std::size_t(object) >= trace.objects.size()) return {};
    const TraceObject& owner = trace.objects[std::size_t(object)];
    if (node < 0 || std::size_t(node) >= owner.nodes.size()) return owner.name;
    const bool root = std::size_t(node) + 1 == owner.nodes.size();
    return root && !owner.name.empty() ? owner.name : owner.nodes[std::size_t(node)].name;
}

vtkSmartPointer<vtkPolyData> spans_polydata(const Trace& trace, double open_length) {
    Lines lines;
    Column<vtkIntArray> id("ray_id"), step("step"), object("object_id"), node("node_id");
    Column<vtkStringArray> names("node_name");
    Column<vtkDoubleArray> enters("t_enter"), exits("t_exit");
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const TracedRay& ray = trace.rays[i];
        const Ray<double> line{ray.start().origin, ray.start().direction};
        const double size = length(line.direction);
        for (std::size_t e = 0; e < ray.events.size(); ++e) {
            const auto* evaluated = std::get_if<NodeEvaluated>(&ray.events[e]);
            if (evaluated == nullptr) continue;
            for (const SpanFound& span : spans_after(ray, e)) {
                const double from = std::max(span.enter.t, 0.0);
                const double far = from + (size > 0 ? open_length / size : 0);
                const double to = std::isfinite(span.exit.t) ? span.exit.t : far;
                if (!(span.exit.t > 0) || !std::isfinite(from)) continue;
                lines.line(line.at(from), line.at(to));
                id.array->InsertNextValue(int(i));
                step.array->InsertNextValue(int(i));
                object.array->InsertNextValue(evaluated->object);
                node.array->InsertNextValue(evaluated->node);
                names.array->InsertNextValue(node_label(trace, evaluated->object, evaluated->node));
                enters.array->InsertNextValue(span.enter.t);
                exits.array->InsertNextValue(span.exit.t);
            }
        }
    }
    lines.data->SetPoints(lines.points);
    lines.data->SetLines(lines.cells);
    for (vtkAbstractArray* column : std::initializer_list<vtkAbstractArray*>{
             id.array, step.array, object.array, node.array, names.array, enters.array, exits.array})
        lines.data->GetCellData()->AddArray(column);
    return lines.data;
}

vtkSmartPointer<vtkPolyData> places_polydata(const Trace& trace) {
    Lines lines;
    Column<vtkIntArray> id("ray_id"), step("step"), number("place"), level("level"), held("held");
    Column<vtkStringArray> objects("object_name");
    Column<vtkDoubleArray> enters("t_in"), exits("t_out");
    const auto add_box = [&](const PlaceEntered& place, std::size_t ray) {
        const auto corner = [&](unsigned i) {
            return Vec3d{(i & 1U) != 0 ? place.high.x : place.low.x,
                         (i & 2U) != 0 ? place.high.y : place.low.y,
                         (i & 4U) != 0 ? place.high.z : place.low.z};
        };
        for (unsigned from = 0; from < 8; ++from)
            for (const unsigned axis : {1U, 2U, 4U}) {
                if ((from & axis) != 0) continue;
                lines.line(corner(from), corner(from | axis));
                id.array->InsertNextValue(int(ray));
                step.array->InsertNextValue(int(ray));
                number.array->InsertNextValue(place.place);
                level.array->InsertNextValue(place.level);
                held.array->InsertNextValue(place.held);
                objects.array->InsertNextValue(place.object == none ? "" : object_name(trace, place.object));
                enters.array->InsertNextValue(place.t_in);
                exits.array->InsertNextValue(place.t_out);
            }
    };
    for (std::size_t i = 0; i < trace.rays.size(); ++i)
        for (const Event& event : trace.rays[i].events)
            if (const auto* place = std::get_if<PlaceEntered>(&event);
                place != nullptr &&
                (place->kind == PlaceKind::cell || place->kind == PlaceKind::extent ||
                 place->kind == PlaceKind::part) &&
                Box<double>{place->low, place->high}.bounded())
                add_box(*place, i);
    lines.data->SetPoints(lines.points);
    lines.data->SetLines(lines.cells);
    for (vtkAbstractArray* column :
         std::initializer_list<vtkAbstractArray*>{id.array, step.array, number.array, level.array, held.array,
                                                  objects.array, enters.array, exits.array})
        lines.data->GetCellData()->AddArray(column);
    return lines.data;
}

} // namespace rayscope::drawing
