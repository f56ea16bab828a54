#include "visualizer/drawing/picture.hpp"

#include "visualizer/drawing/details_panel.hpp"
#include "visualizer/drawing/framing.hpp"
#include "visualizer/drawing/legend.hpp"
#include "visualizer/drawing/marks.hpp"
#include "visualizer/drawing/raster.hpp"
#include "visualizer/drawing/scene_objects.hpp"
#include "visualizer/drawing/surface_paint.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/drawing/timeline.hpp"
#include "visualizer/drawing/trace_geometry.hpp"
#include "visualizer/drawing/tree_panel.hpp"
#include "visualizer/drawing/write_png.hpp"

#include <algorithm>

namespace rayscope::drawing {
namespace {

std::string title_of(const Trace& trace, bool chosen, int current) {
    const std::string count = std::to_string(trace.rays.size());
    const TracedRay& ray = trace.rays[std::size_t(current)];
    std::string title;
    if (chosen)
        title = "Ray " + std::to_string(current) + " of " + std::to_string(trace.rays.size() - 1) + ": " +
                kind_name(ray.start().kind) + ", depth " + std::to_string(ray.start().depth);
    else
        title = trace.rays.size() == 1 ? "One ray" : "All " + count + " rays";
    if (trace.source.by_hand)
        return title + (trace.rays.size() == 1 ? ", given by hand" : ", the first given by hand");
    title += (chosen ? "; pixel (" : " of pixel (") + std::to_string(trace.source.x) + ", " +
             std::to_string(trace.source.y) + ")";
    return trace.source.sample > 0 ? title + ", sample " + std::to_string(trace.source.sample) : title;
}

void draw_title(Canvas& canvas, const Layout& layout, const std::string& title, const Trace& trace,
                const std::string& remark) {
    const Area& area = layout.title;
    const double font = layout.font, y = area.y + area.height / 2;
    canvas.add(FilledArea{area, paper});
    const double size = font * 1.3;
    canvas.add(Text{{font, y}, title, size, ink, Font::bold});
    const double used = font + text_width(title, Font::bold, size) + 1.5 * font;
    std::string scene = std::filesystem::path(trace.source.scene).filename().string();
    if (!remark.empty()) scene += (scene.empty() ? "" : "   ") + remark;
    canvas.add(Text{{area.right() - font, y},
                    elided(scene, Font::sans, font, area.right() - font - used),
                    font,
                    quiet_ink,
                    Font::sans,
                    Align::right});
}

std::string remark_of(const Surfaces& surfaces, const Trace& trace, std::size_t drawn_rays) {
    std::string remark;
    if (surfaces.left_out > 0) remark = std::to_string(surfaces.left_out) + " objects not drawn";
    if (drawn_rays < trace.rays.size())
        remark += (remark.empty() ? "" : ", ") + std::to_string(trace.rays.size() - drawn_rays) +
                  " lightest rays not drawn";
    if (trace.events_dropped > 0)
        remark += std::string(remark.empty() ? "" : ", ") + "the trace was cut short";
    return remark;
}

} // namespace

Raster draw_picture(const Workbench& bench, const Trace& trace, const PictureOptions& options) {
    if (trace.rays.empty())
        throw InputError(trace.source.scene, {}, "the trace has no rays: there is nothing to draw");
    const bool chosen = options.ray != none;
    const int current = chosen ? options.ray : 0;
    if (current < 0 || std::size_t(current) >= trace.rays.size())
        throw InputError(trace.source.scene, {}, "the trace has no ray " + std::to_string(options.ray));

    const Lanes lanes = lanes_of(trace, trace.rays[std::size_t(current)], most_lanes(options.size));
    const Layout layout = layout_of(options.size, trace, current, chosen, lanes);
    const std::vector<Id> drawn = drawn_objects(trace, bench.scene);
    const Region region = region_of(trace, bench, drawn);
    const View view = framed(trace, bench.scene, region, layout.view, options.ray);
    const Surfaces surfaces = surfaces_near(bench, trace, drawn, region);
    const std::vector<RayStyle> styles =
        ray_styles(trace, chosen && trace.rays.size() > 1 ? std::optional(current) : std::nullopt);

    RayStrokes strokes(view, region, layout.pixels);
    strokes.draw(trace, styles, rays_polydata(trace, region.open_length()), hits_polydata(trace));
    strokes.draw_places(current, places_polydata(trace));
    strokes.draw_lanes(trace, current, lanes, spans_polydata(trace, region.open_length()));

    Canvas canvas;
    LabelPlacer placer(layout.view, strokes.segments());
    draw_marks(canvas, placer, trace, styles, surfaces, bench, region, view, layout.font);
    draw_title(canvas, layout, title_of(trace, chosen, current), trace,
               remark_of(surfaces, trace, styles.size()));
    canvas.add(FilledArea{layout.legend, paper});
    draw_legend(&canvas, layout.font, layout.legend.y + layout.font * 0.25,
                layout.legend.width - 2 * layout.font, trace, chosen, layout.font * 0.95);
    draw_timeline(canvas, layout.timeline, lanes, trace, current, layout.font);
    canvas.add(FilledArea{{layout.tree.x, 0, layout.tree.width, double(options.size.height)}, panel});
    draw_tree(canvas, layout.tree, trace, current, layout.font);
    draw_details(canvas, layout.details, trace, current, layout.font);
    canvas.add(Stroke{{{layout.tree.x, 0}, {layout.tree.x, double(options.size.height)}}, hair, 1});
    return rasterize(options.size, view, paint_surfaces(surfaces, bench.scene, view), strokes.mesh(), canvas,
                     layout.pixels);
}

void write_picture(const Workbench& bench, const Trace& trace, const std::filesystem::path& path,
                   const PictureOptions& options) {
    check_writable(path);
    const Raster raster = draw_picture(bench, trace, options);
    write_png(raster, path);
}

} // namespace rayscope::drawing
