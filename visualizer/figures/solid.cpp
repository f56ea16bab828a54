#include "visualizer/figures/solid.hpp"

#include "visualizer/drawing/raster.hpp"
#include "visualizer/drawing/surfaces.hpp"
#include "visualizer/drawing/write_png.hpp"

#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace rayscope::figures {
namespace {

using drawing::Region;

std::vector<Vec3d> points_of(const Stand& stand) {
    if (!stand.seen.empty()) return stand.seen;
    std::vector<Vec3d> points;
    const Vec3d back = normalized(stand.back), right = normalized(cross(stand.up, back)),
                up = cross(back, right);
    for (const Vec3d& d : {right, -right, up, -up}) points.push_back(stand.centre + d * stand.radius);
    return points;
}

drawing::Surfaces surfaces_of(const Workbench& bench, const Region& region) {
    drawing::Surfaces surfaces;
    constexpr int around = 128;
    for (std::size_t i = 0; i < bench.scene.drawn.size(); ++i) {
        const auto& drawn = bench.scene.drawn[i];
        const bool flat = !drawn.is_compound && !bench.world.objects[i].bounds.bounded();
        surfaces.shown.push_back({i, "", true, false, flat, false,
                                  drawing::object_surface(bench.scene, i, {around, false}, region)});
    }
    return surfaces;
}

void make_opaque(vtkPolyData* faces) {
    auto* colours = vtkUnsignedCharArray::SafeDownCast(faces->GetPointData()->GetScalars());
    if (colours == nullptr) return;
    for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i) colours->SetTypedComponent(i, 3, 255);
}

} // namespace

Solid::Solid(Svg& svg, const drawing::Area& area, const Workbench& bench, const Stand& stand)
    : region_{stand.centre, stand.radius, {}},
      view_(region_, area, normalized(stand.back), stand.up, points_of(stand), stand.share) {
    const drawing::PictureSize size{int(area.width * stand.detail), int(area.height * stand.detail)};
    const drawing::View camera(region_, {0, 0, double(size.width), double(size.height)},
                               normalized(stand.back), stand.up, points_of(stand), stand.share);
    const drawing::PaintedSurfaces painted =
        drawing::paint_surfaces(surfaces_of(bench, region_), bench.scene, camera);
    if (stand.opaque) make_opaque(painted.faces);
    svg.image(area, drawing::png_bytes(
                        drawing::rasterize(size, camera, painted, drawing::Mesh(), {}, stand.detail)));
}

Pixel Solid::operator()(const Vec3d& world) const { return view_.pixel(view_.to_view(world)).value(); }
Pixel Solid::operator()(const Vec3d& world, double x, double y) const {
    const Pixel p = (*this)(world);
    return {p.x + x, p.y + y};
}

std::vector<std::uint8_t> png_of(const Image& image) {
    drawing::Raster raster{image.width, image.height, {}};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (const std::uint8_t byte : srgb_bytes(image.at(x, y))) raster.bytes.push_back(byte);
    return drawing::png_bytes(raster);
}

} // namespace rayscope::figures
