// The way of a mirrored ray through the cells of an octree.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"
#include "visualizer/figures/solid.hpp"

#include <array>

namespace rayscope::figures {
namespace {

struct Looked {
    PlaceEntered cell;
    PlaceLeft left;
};

std::vector<Looked> cells_of(const TracedRay& ray) {
    std::vector<Looked> list;
    const PlaceEntered* cell = nullptr;
    for (const Event& event : ray.events) {
        if (const auto* entered = std::get_if<PlaceEntered>(&event))
            cell = entered->kind == PlaceKind::cell ? entered : nullptr;
        if (const auto* left = std::get_if<PlaceLeft>(&event); left != nullptr && cell != nullptr)
            list.push_back({*cell, *left});
    }
    return list;
}

void draw_box(Svg& svg, const Solid& solid, const Vec3d& low, const Vec3d& high, const Pen& pen) {
    const auto corner = [&](unsigned i) {
        return solid(
            {(i & 1U) != 0 ? high.x : low.x, (i & 2U) != 0 ? high.y : low.y, (i & 4U) != 0 ? high.z : low.z});
    };
    for (unsigned i = 0; i < 8; ++i)
        for (const unsigned bit : {1U, 2U, 4U})
            if ((i & bit) == 0) svg.line(corner(i), corner(i | bit), pen);
}

void draw_badge(Svg& svg, Pixel at, std::size_t number, Rgb colour) {
    svg.dot(at, 17, white);
    svg.circle(at, 16, {colour, 3.5});
    svg.text(at, std::to_string(number), {21, colour, true});
}

constexpr std::array<Rgb, 2> cell_colours{blue, vermilion};
constexpr std::array<const char*, 2> cell_dashes{"", "10 6"};

/// The short way of the ray, in the plane through it and along x: there the face between the cells is a line.
void draw_close(Svg& svg, const Subject& subject, const drawing::Area& area, const Trace& trace, int index,
                const std::vector<Looked>& cells) {
    const RaySpawned& start = trace.rays[std::size_t(index)].start();
    const Vec3d d = start.direction, x{1, 0, 0};
    const BoundaryChosen& hit = hit_of(trace, index);
    const double face = cells.front().cell.low.x;
    const Vec3d across = normalized(x * dot(d, x) - d); // up the page
    const Vec3d middle = (start.origin + hit.point) / 2.0;
    const Sheet sheet{
        middle + x * (face - middle.x), x, across, {area.x + area.width / 2, area.y + area.height / 2}, 520};
    const double half_width = area.width / 2 / sheet.scale, half_height = area.height / 2 / sheet.scale;
    svg.rectangle({area.x, area.y, area.width / 2, area.height}, {cell_colours[1], 0.12});
    svg.rectangle({area.x + area.width / 2, area.y, area.width / 2, area.height}, {cell_colours[0], 0.12});
    constexpr std::array<const char*, 3> names{"ring_2", "ring_3", "ring_4"};
    for (const char* name : names) {
        const Workbench ring = apart(subject.bench.scene, {name});
        svg.area(section(sheet, -half_height, half_height,
                         [&](const Ray<double>& ray) {
                             List shown;
                             for (const auto& [enter, exit] : list_of(ring, ray))
                                 if (exit > -half_width && enter < half_width)
                                     shown.emplace_back(std::max(enter, -half_width),
                                                        std::min(exit, half_width));
                             return shown;
                         }),
                 {orange, 0.55});
    }
    svg.text({area.x + 70, sheet.at.y + 150}, "ring_2", {20, black, true});
    svg.text({area.right() - 60, sheet.at.y + 150}, "ring_4", {20, black, true});
    svg.line({sheet.at.x, area.y}, {sheet.at.x, area.bottom()}, {black, 2.5, "3 5"});
    svg.frame(area, {grey, 1.5});
    svg.line(sheet(start.origin), sheet(hit.point), pen_of(RayKind::reflected, 4));
    svg.heading(sheet(start.origin), sheet(hit.point), pen_of(RayKind::reflected, 4), 0.35);
    const double t_face = cells.back().cell.t_in;
    struct Point {
        double t;
        double x, y;
        Anchor anchor;
    };
    for (const Point& point : {Point{0, 18, -14, Anchor::start}, Point{t_face, 18, 16, Anchor::start},
                               Point{hit.boundary.t, -16, 24, Anchor::end}}) {
        svg.dot(sheet(start.origin + d * point.t), 7, purple);
        svg.text(sheet(start.origin + d * point.t, point.x, point.y), "t = " + digits(point.t, 4),
                 {19, black, true, point.anchor});
    }
    draw_badge(svg, {area.right() - 30, area.y + 30}, 1, cell_colours[0]);
    draw_badge(svg, {area.x + 30, area.y + 30}, 2, cell_colours[1]);
}

} // namespace

Svg octree_walk(const Subject& subject) {
    const auto stages = make_stages(subject.bench, stage_choice("octree"));
    const Trace trace = trace_pixel(subject.bench, *stages, 330, 190);
    const int mirrored = child_of(trace, 0, RayKind::reflected);
    const TracedRay& ray = trace.rays[std::size_t(mirrored)];
    const auto* root = ray.find<PlaceEntered>();
    const std::vector<Looked> cells = cells_of(ray);
    if (root == nullptr || root->kind != PlaceKind::node || cells.size() != 2)
        throw InputError(trace.source.scene, {}, "a figure's ray does not come through two cells");

    Svg svg(1000, 800);
    Stand stand;
    stand.back = {-0.75, 0.45, 1};
    stand.centre = (root->low + root->high) / 2.0;
    stand.radius = length(root->high - root->low) / 2;
    stand.opaque = true;
    stand.share = 1.3;
    for (unsigned i = 0; i < 8; ++i)
        stand.seen.push_back({(i & 1U) != 0 ? root->high.x : root->low.x,
                              (i & 2U) != 0 ? root->high.y : root->low.y,
                              (i & 4U) != 0 ? root->high.z : root->low.z});
    const Workbench rings = apart(subject.bench.scene, {"ring_1", "ring_2", "ring_3", "ring_4", "ring_5"});
    const Solid solid(svg, {0, 40, 540, 560}, rings, stand);
    const double edge = (root->high.x - root->low.x) / 2;
    for (unsigned i = 0; i < 8; ++i) {
        const Vec3d low =
            root->low + Vec3d{double(i & 1U), double(i >> 1U & 1U), double(i >> 2U & 1U)} * edge;
        draw_box(svg, solid, low, low + Vec3d{edge}, {{0xA8, 0xAE, 0xB8}, 1.5});
    }
    for (std::size_t k = cells.size(); k-- > 0;)
        draw_box(svg, solid, cells[k].cell.low, cells[k].cell.high, {cell_colours[k], 3, cell_dashes[k]});
    const Vec3d from = trace.rays[0].start().origin, p = hit_of(trace, 0).point,
                to = hit_of(trace, mirrored).point;
    svg.line(solid(p + normalized(from - p) * 6.0), solid(p), pen_of(RayKind::eye, 3));
    svg.heading(solid(p + normalized(from - p) * 6.0), solid(p), pen_of(RayKind::eye, 3), 0.5);
    svg.line(solid(p), solid(to), {blue, 4});
    for (std::size_t k = 0; k < cells.size(); ++k) {
        const Vec3d low = cells[k].cell.low, high = cells[k].cell.high;
        draw_badge(svg, solid({k == 0 ? high.x - 0.5 : low.x + 0.5, high.y - 0.5, high.z}), k + 1,
                   cell_colours[k]);
    }
    svg.text({270, 22}, "the root and its eight parts", {21, black, true});
    svg.text({775, 22}, "the mirrored ray, close up", {21, black, true});
    draw_close(svg, subject, {560, 60, 430, 520}, trace, mirrored, cells);

    double y = 640;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        draw_badge(svg, {40, y}, k + 1, cell_colours[k]);
        svg.text({70, y},
                 "cell " + std::to_string(cells[k].cell.place) + ": holds " +
                     std::to_string(cells[k].cell.held) + ", tested " + std::to_string(cells[k].left.tested) +
                     ", spared " + std::to_string(cells[k].left.spared),
                 {20, black, false, Anchor::start});
        y += 42;
    }
    y += 16;
    svg.text({24, y},
             std::to_string(8 - root->held) +
                 " of the root’s 8 parts are empty (thin grey lines): no ray looks into them",
             {20, black, false, Anchor::start});
    svg.text({24, y + 34}, "black: the eye’s ray; short and blue: the mirrored ray",
             {20, black, false, Anchor::start});
    svg.text({560, 640}, "orange: the rings, cut by the plane", {20, black, false, Anchor::start});
    svg.text({560, 668}, "of the ray and the x axis; dotted:", {20, black, false, Anchor::start});
    svg.text({560, 696}, "the face between the two cells", {20, black, false, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
