// What a light sees: its window, cut into cells, and how many objects each lists.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/solid.hpp"

#include <algorithm>
#include <numbers>

namespace rayscope::figures {
namespace {

/// The first shadow ray that asked the light for a cell, and what it read there.
struct Asked {
    Vec3d from;
    int column = 0, row = 0, held = 0;
    std::string read; ///< the objects whose entries it read
};

Asked asked_by(const Trace& trace, const Vec3d& light) {
    for (const TracedRay& ray : trace.rays) {
        const auto* place = ray.find<PlaceEntered>();
        if (ray.start().kind != RayKind::shadow || place == nullptr || place->kind != PlaceKind::light_cell ||
            trace.lights[std::size_t(ray.start().light)].position != light)
            continue;
        Asked asked{ray.start().origin, int(place->low.x), int(place->low.y), place->held, {}};
        for (const Event& event : ray.events)
            if (const auto* entry = std::get_if<PlaceEntered>(&event);
                entry != nullptr && entry->kind == PlaceKind::entry)
                asked.read +=
                    (asked.read.empty() ? "" : ", ") + trace.objects[std::size_t(entry->object)].name;
        return asked;
    }
    throw InputError(trace.source.scene, {}, "a figure's ray asks the light for no cell");
}

} // namespace

Svg light_cells(const Subject& subject) {
    const Workbench& bench = subject.bench;
    const auto windows = light_windows(bench, 0);
    if (windows.size() != 1)
        throw InputError(bench.scene.file, {}, "a figure needs a light before which all objects lie");
    const LightView& view = windows[0].view;
    const auto at_column = [&](double cell) { return view.left + cell / view.cells * view.width; };
    const auto at_row = [&](double cell) { return view.top + cell / view.cells * view.height; };

    // The image from the light: it sees no shadow of its own.
    const double half_width = 1.04 * std::max(-view.left, view.left + view.width),
                 half_height = 1.04 * std::max(-view.top, view.top + view.height);
    constexpr int width = 400;
    const int height = int(std::lround(width * half_height / half_width));
    constexpr double wide = 580;
    const double scale = wide / (2 * half_width), bottom = 2 * half_height * scale;
    Scene scene = bench.scene;
    scene.camera.eye = view.position;
    scene.camera.look_at = view.position + view.forward;
    scene.camera.up = -view.down;
    scene.camera.field_of_view = 2 * std::atan(half_height) * 180 / std::numbers::pi;
    RenderOptions options;
    options.width = width;
    options.height = height;
    Svg svg(1000, bottom);
    svg.image({0, 0, wide, bottom}, png_of(render(make_workbench(scene), options).image));
    svg.rectangle({0, 0, wide, bottom}, {white, 0.4});
    const auto page = [&](double x, double y) {
        return Pixel{(x + half_width) * scale, (y + half_height) * scale};
    };
    for (int i = 0; i <= view.cells; ++i) {
        svg.line(page(at_column(i), view.top), page(at_column(i), view.top + view.height), {grey, 1.2});
        svg.line(page(view.left, at_row(i)), page(view.left + view.width, at_row(i)), {grey, 1.2});
    }
    for (int y = 0; y < view.cells; ++y)
        for (int x = 0; x < view.cells; ++x)
            if (const std::size_t held = windows[0].held[std::size_t(y * view.cells + x)]; held > 0)
                svg.text(page(at_column(x + 0.5), at_row(y + 0.5)), std::to_string(held), {19});

    // One shadow ray. The light sees it as a point.
    const auto stages = make_stages(bench, stage_choice("light"));
    const Asked one = asked_by(trace_pixel(bench, *stages, 330, 250), view.position);
    const Vec3d seen = view.from_light(one.from) / view.from_light(one.from).z;
    const Pixel corner = page(at_column(one.column), at_row(one.row)),
                across = page(at_column(one.column + 1), at_row(one.row + 1));
    const drawing::Area marked{corner.x, corner.y, across.x - corner.x, across.y - corner.y};
    svg.frame(marked, {white, 8});
    svg.frame(marked, {vermilion, 5});
    svg.dot(page(seen.x, seen.y), 8, purple);
    const auto say = [&](double y, const std::string& words, bool bold = false) {
        svg.text({650, y}, words, {20, black, bold, Anchor::start});
    };
    const auto number = [](auto count) { return std::to_string(count); };
    say(40, "What the lamp sees", true);
    say(72, number(view.cells) + " × " + number(view.cells) + " cells; the number:");
    say(100, "objects in the cell’s list");
    say(128, "(no number: none)");
    svg.dot({625, 190}, 8, purple);
    say(190, "a shadow ray: the lamp");
    say(218, "sees it as one point");
    svg.frame({613, 263, 24, 24}, {vermilion, 5});
    say(275, "the cell that it comes");
    say(303, "through: " + number(one.held) + " of " + number(bench.world.objects.size()) + " objects");
    say(331, "asked: " + one.read);
    say(393, "The lamp sees no shadow of");
    say(421, "its own; those here are the");
    say(449, "other lamp’s.");
    say(511, "All objects lie before the");
    say(539, "lamp: one window will do,");
    say(567, "in place of a cube’s six sides.");
    return svg;
}

} // namespace rayscope::figures
