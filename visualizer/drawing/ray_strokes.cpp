#include "visualizer/drawing/ray_strokes.hpp"

#include "visualizer/drawing/clip_compound.hpp"
#include "visualizer/drawing/ray_path.hpp"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <map>

namespace rayscope::drawing {
namespace {

struct Weights {
    double line, arrow, dot;
    double fade; ///< towards the ground's colour
};

Weights weights_of(Emphasis emphasis) {
    switch (emphasis) {
    case Emphasis::ghost: return {1.1, 7, 2.2, 0.68};
    case Emphasis::plain: return {2.0, 11, 3.4, 0.0};
    default: return {3.6, 15, 4.6, 0.0};
    }
}

constexpr std::size_t many_rays = 60;

// In radii of the region.
constexpr double rays_within = 50; // what the graphics card's numbers can hold beside the region
constexpr double lanes_within = 1.1;

/// The part of a segment within a ball around the region's middle.
std::optional<std::pair<Vec3d, Vec3d>> within_reach(const Vec3d& from, const Vec3d& to, double reach) {
    const double size = length(to - from);
    if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
    const Vec3d d = normalized(to - from);
    const double middle = -dot(from, d), squared = reach * reach - dot(from + d * middle, from + d * middle);
    if (!(squared > 0)) return std::nullopt;
    const double low = std::max(0.0, middle - std::sqrt(squared)),
                 high = std::min(size, middle + std::sqrt(squared));
    if (!(low < high)) return std::nullopt;
    return std::pair{low > 0 ? from + d * low : from, high < size ? from + d * high : to};
}

double cell_value(vtkPolyData* data, const char* array, vtkIdType cell) {
    return data->GetCellData()->GetArray(array)->GetTuple1(cell);
}

} // namespace

std::vector<RayStyle> ray_styles(const Trace& trace, std::optional<int> chosen) {
    std::vector<RayStyle> styles;
    std::vector<Emphasis> emphasis(trace.rays.size(), chosen ? Emphasis::ghost : Emphasis::plain);
    if (chosen) {
        for (std::size_t i = 0; i < trace.rays.size(); ++i) {
            const int parent = trace.rays[i].parent;
            const bool below = parent >= 0 && parent < int(i) &&
                               (parent == *chosen || emphasis[std::size_t(parent)] == Emphasis::plain);
            if (below) emphasis[i] = Emphasis::plain;
        }
        for (const int i : path_to(trace, *chosen)) emphasis[std::size_t(i)] = Emphasis::path;
    }
    for (std::size_t i = 0; i < trace.rays.size(); ++i) styles.push_back({int(i), emphasis[i]});
    std::ranges::stable_sort(styles, [&](const RayStyle& a, const RayStyle& b) {
        if (a.emphasis != b.emphasis) return a.emphasis > b.emphasis;
        return weight(trace.rays[std::size_t(a.ray)]) > weight(trace.rays[std::size_t(b.ray)]);
    });
    if (styles.size() > most_rays) styles.resize(most_rays);
    return styles;
}

void RayStrokes::tube(const Vec3d& from, const Vec3d& to, double width, Rgb colour) {
    const double half = width * pixels_ / 2;
    mesh_.add_tube(from, to, half * view_.pixel_size(from), half * view_.pixel_size(to), colour);
}

void RayStrokes::dashes(const Vec3d& from, const Vec3d& to, double width, Rgb colour) {
    const double pixel = view_.pixel_size((from + to) / 2.0) * pixels_, size = length(to - from);
    const double dash = (6 + 1.5 * width) * dash_ * pixel, period = dash + (3 + 1.5 * width) * dash_ * pixel;
    if (!(size < 1000 * period)) return tube(from, to, width, colour);
    const Vec3d d = normalized(to - from);
    for (double s = 0; s < size; s += period)
        tube(from + d * s, from + d * std::min(s + dash, size), width, colour);
}

void RayStrokes::solid_arrow(const Vec3d& at, const Vec3d& direction, double size, Rgb colour) {
    // Turned into the plane of the picture: a cone that points at the camera looks like a ball.
    const Vec3d sight = normalized(view_.position() - at);
    const Vec3d flat = direction - sight * dot(direction, sight);
    if (length(flat) < 0.12) return;
    const Vec3d half = normalized(flat) * (size * view_.pixel_size(at) * pixels_ / 2);
    mesh_.add_cone(at - half, at + half, 0.72 * length(half), colour);
}

void RayStrokes::open_arrow(const Vec3d& tip, const Vec3d& direction, double width, Rgb colour) {
    const Vec3d across = normalized(cross(direction, view_.position() - tip));
    const double size = (7 + 1.5 * width) * view_.pixel_size(tip) * pixels_;
    for (const double side : {-0.5, 0.5})
        tube(tip, tip - direction * size + across * (size * side), width, colour);
}

void RayStrokes::draw_ray(const TracedRay& ray, const Vec3d& first, const Vec3d& last, bool open,
                          Emphasis emphasis) {
    const auto near = within_reach(first, last, rays_within);
    if (!near) return;
    const auto& [from, to] = *near;
    const Weights w = weights_of(emphasis);
    const bool shadow = ray.start().kind == RayKind::shadow;
    // Shadow rays are many and say little: they stand back.
    const Rgb colour = mixed(ray_colour(ray), sky, shadow && emphasis == Emphasis::plain ? 0.2 : w.fade);
    const double width = shadow ? w.line * 0.7 : w.line;
    // What lies far outside the picture would only cost precision.
    const auto drawn = view_.visible(from, to, -0.3 * view_.area().width);
    const auto seen = view_.visible(from, to, 7 * pixels_);
    if (!drawn || !seen) return;
    const auto at = [&](double share) { return from + (to - from) * share; };
    const Vec3d start = at(drawn->from), end = at(drawn->to), direction = normalized(to - from);
    const bool leaves = seen->to < 1;
    if (shadow)
        dashes(start, leaves ? at(seen->to) : end, width, colour);
    else
        tube(start, open && leaves ? at(seen->to) : end, width, colour);
    const auto a = view_.pixel(at(seen->from)), b = view_.pixel(at(seen->to));
    if (!a || !b) return;
    if (emphasis != Emphasis::ghost) segments_.push_back({*a, *b});
    const double visible_pixels = std::hypot(b->x - a->x, b->y - a->y) / pixels_;
    if (open || (shadow && leaves))
        open_arrow(at(seen->to), direction, width * 0.8, colour);
    else if (is_blocked(ray))
        return;
    const double size = std::min(w.arrow, visible_pixels * 0.3);
    if (size > 4 && !(open && visible_pixels < 50))
        solid_arrow(at(seen->from + (seen->to - seen->from) * (open ? 0.5 : 0.57)), direction, size, colour);
}

void RayStrokes::draw_hit(const Vec3d& point, const Vec3d& normal, bool with_normal, Emphasis emphasis) {
    const auto pixel = view_.pixel(point);
    if (!pixel || !view_.visible(point, point + view_.right() * view_.pixel_size(point), 0)) return;
    const Weights w = weights_of(emphasis);
    const double size = view_.pixel_size(point) * pixels_;
    mesh_.add_ball(point, w.dot * size, mixed(hit_purple, sky, w.fade));
    if (!with_normal) return;
    const Rgb green = mixed(normal_green, sky, w.fade);
    const Vec3d tip = point + normal * (30 * size);
    tube(point, tip, emphasis == Emphasis::path ? 2 : 1.4, green);
    solid_arrow(tip, normal, 9, green);
    if (const auto end = view_.pixel(tip)) segments_.push_back({*pixel, *end});
}

void RayStrokes::draw(const Trace& trace, const std::vector<RayStyle>& styles, vtkPolyData* rays,
                      vtkPolyData* hits) {
    std::vector<vtkIdType> hit_of(trace.rays.size(), none);
    vtkDataArray* ids = hits->GetPointData()->GetArray("ray_id");
    for (vtkIdType i = 0; i < hits->GetNumberOfPoints(); ++i) hit_of[std::size_t(ids->GetTuple1(i))] = i;
    const bool few_hits = hits->GetNumberOfPoints() <= 14;
    std::size_t normals = 0;
    for (const RayStyle& style : styles) {
        // Thin and many: nobody sees how round they are.
        const bool many = styles.size() > many_rays && style.emphasis != Emphasis::path;
        mesh_.set_sides(many ? Mesh::round / 2 : Mesh::round);
        dash_ = many ? 2.5 : 1;
        const vtkIdType cell = style.ray; // one line for each ray, in their order
        const Vec3d from = view_.to_view(point_of(rays, 2 * cell)),
                    to = view_.to_view(point_of(rays, 2 * cell + 1));
        draw_ray(trace.rays[std::size_t(style.ray)], from, to, cell_value(rays, "open", cell) > 0,
                 style.emphasis);
        const vtkIdType hit = hit_of[std::size_t(style.ray)];
        if (hit == none) continue;
        std::array<double, 3> n{};
        hits->GetPointData()->GetNormals()->GetTuple(hit, n.data());
        const bool with_normal = style.emphasis == Emphasis::path ||
                                 (style.emphasis == Emphasis::plain && (few_hits || normals < 8));
        if (with_normal) ++normals;
        draw_hit(view_.to_view(point_of(hits, hit)), {n[0], n[1], n[2]}, with_normal, style.emphasis);
    }
    mesh_.set_sides(Mesh::round);
}

void RayStrokes::draw_lanes(const Trace& trace, int ray, const Lanes& lanes, vtkPolyData* spans) {
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    const RaySpawned& start = traced.start();
    const auto* hit = traced.find<BoundaryChosen>();
    const Vec3d direction = normalized(start.direction);
    Vec3d aside = normalized(cross(direction, view_.back()));
    if (dot(aside, view_.up()) < 0) aside = -aside;
    std::map<std::pair<int, int>, std::size_t> row; // (object, node) → which lane
    for (std::size_t i = 0; i < lanes.shown.size(); ++i)
        row.try_emplace({lanes.shown[i].object, lanes.shown[i].node}, i);
    for (vtkIdType i = 0; i < spans->GetNumberOfCells(); ++i) {
        if (int(cell_value(spans, "ray_id", i)) != ray) continue;
        const auto lane =
            row.find({int(cell_value(spans, "object_id", i)), int(cell_value(spans, "node_id", i))});
        if (lane == row.end()) continue;
        // Beside the ray there is room for the object that it hits; the timeline has the others.
        if (hit != nullptr && lane->first.first != hit->object) continue;
        const auto near = within_reach(view_.to_view(point_of(spans, 2 * i)),
                                       view_.to_view(point_of(spans, 2 * i + 1)), lanes_within);
        if (!near) continue;
        const auto& [from, to] = *near;
        const auto part = view_.visible(from, to, -4 * pixels_);
        if (!part) continue;
        const double pixel = view_.pixel_size(from) * pixels_;
        const Vec3d offset = aside * ((10 + 6.5 * double(lane->second)) * pixel);
        const Vec3d a = from + (to - from) * part->from + offset, b = from + (to - from) * part->to + offset;
        tube(a, b, 4, lanes.shown[lane->second].colour);
        const auto flat_a = view_.pixel(a), flat_b = view_.pixel(b);
        if (flat_a && flat_b) segments_.push_back({*flat_a, *flat_b});
    }
}

void RayStrokes::draw_places(int ray, vtkPolyData* places) {
    for (vtkIdType i = 0; i < places->GetNumberOfCells(); ++i) {
        if (int(cell_value(places, "ray_id", i)) != ray) continue;
        const auto near = within_reach(view_.to_view(point_of(places, 2 * i)),
                                       view_.to_view(point_of(places, 2 * i + 1)), rays_within);
        if (!near) continue;
        const auto& [from, to] = *near;
        const auto part = view_.visible(from, to, -0.3 * view_.area().width);
        if (!part) continue;
        tube(from + (to - from) * part->from, from + (to - from) * part->to, 1.1, place_blue);
    }
}

} // namespace rayscope::drawing
