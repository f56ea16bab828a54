// Where the light of an image comes from: the ledger's entries as bars.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/rays.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace rayscope::figures {
namespace {

constexpr RayKind ray_bringers[] = {RayKind::eye, RayKind::reflected, RayKind::refracted};
constexpr double bars_begin = 210, bars_end = 880; // where bars begin, and where the longest may end

double mean_of(const Colour& colour) { return (colour.r + colour.g + colour.b) / 3; }

std::string per_cent(double share) {
    return share > 0 && share < 0.0005 ? "less than 0.1 %" : fmt::format("{:.1f} %", 100 * share);
}

struct LightBar {
    std::string name;
    double parts[3] = {0, 0, 0}; ///< shares of all light, by bringer
    [[nodiscard]] double sum() const { return parts[0] + parts[1] + parts[2]; }
};

LightBar bar_of(const Ledger& ledger, const std::string& name,
                const std::function<bool(const LightSource&)>& belongs) {
    LightBar bar{name};
    for (const auto& [source, colour] : ledger.sources)
        if (belongs(source))
            bar.parts[std::size_t(source.brought_by)] += mean_of(colour) / mean_of(ledger.total);
    return bar;
}

Rgb colour_of(RayKind bringer) {
    constexpr Rgb colours[] = {grey, sky_blue, vermilion};
    return colours[std::size_t(bringer)];
}

/// Each kind of ray has lines of its own over its colour: none, upright, level.
void draw_part(Svg& svg, const drawing::Area& area, RayKind bringer) {
    svg.rectangle(area, {colour_of(bringer), 0.85});
    if (bringer == RayKind::reflected)
        for (double x = area.x + 4; x < area.right(); x += 7)
            svg.line({x, area.y}, {x, area.bottom()}, {black, 1.5});
    if (bringer == RayKind::refracted)
        for (double y = area.y + 4; y < area.bottom(); y += 7)
            svg.line({area.x, y}, {area.right(), y}, {black, 1.5});
}

void draw_bar(Svg& svg, const LightBar& bar, double y, double scale) {
    constexpr double height = 30;
    svg.text({bars_begin - 14, y}, bar.name, {20, black, false, Anchor::end});
    double x = bars_begin;
    for (const RayKind bringer : ray_bringers) {
        const double width = bar.parts[std::size_t(bringer)] * scale;
        if (width > 0) draw_part(svg, {x, y - height / 2, width, height}, bringer);
        x += width;
    }
    svg.text({x + 12, y}, per_cent(bar.sum()), {20, black, true, Anchor::start});
}

} // namespace

Svg energy_ledger(const Subject& subject) {
    const Scene& scene = subject.bench.scene;
    constexpr int width = 64, lines = 48; // as in the lesson's own table
    const Ledger book = ledger(subject.bench, width, lines);
    std::vector<LightBar> objects, kinds;
    for (std::size_t i = 0; i < scene.drawn.size(); ++i) {
        const SceneObject& drawn = scene.drawn[i];
        objects.push_back(bar_of(book, object_title(scene, drawn),
                                 [i](const LightSource& source) { return source.object == Id(i); }));
    }
    objects.push_back(bar_of(book, "background", [](const LightSource& s) { return s.object == none; }));
    std::stable_sort(objects.begin(), objects.end(),
                     [](const LightBar& a, const LightBar& b) { return a.sum() > b.sum(); });
    for (const LightKind kind :
         {LightKind::ambient, LightKind::diffuse, LightKind::specular, LightKind::background})
        kinds.push_back(bar_of(book, std::string(light_kind_names[std::size_t(kind)]),
                               [kind](const LightSource& source) { return source.kind == kind; }));

    double most = 0;
    for (const std::vector<LightBar>& bars : {objects, kinds})
        for (const LightBar& bar : bars) most = std::max(most, bar.sum());
    const double scale = (bars_end - bars_begin) / most, step = 42;
    const double height = 60 + step * double(objects.size() + kinds.size() + 5) + 16;
    Svg svg(1000, height);
    double x = bars_begin;
    for (const RayKind bringer : ray_bringers) {
        constexpr const char* names[] = {"brought by the eye's ray", "by mirrored rays", "by bent rays"};
        draw_part(svg, {x, 12, 40, 24}, bringer);
        svg.text({x + 50, 24}, names[std::size_t(bringer)], {19, black, false, Anchor::start});
        x += bringer == RayKind::eye ? 330 : 240;
    }
    double y = 76;
    const auto heading = [&](const char* words) {
        svg.text({20, y}, words, {21, black, true, Anchor::start});
        y += step;
    };
    const auto draw = [&](const std::vector<LightBar>& bars) {
        const double top = y - step / 2;
        for (const LightBar& bar : bars) {
            draw_bar(svg, bar, y, scale);
            y += step;
        }
        svg.line({bars_begin, top}, {bars_begin, y - step / 2}, {black, 2});
    };
    heading("From which object");
    draw(objects);
    heading("Of which kind");
    draw(kinds);
    heading("Lost on the way");
    svg.text({bars_begin - 14, y}, "absorbed", {20, black, false, Anchor::end});
    const double swallowed = mean_of(book.absorbed) / mean_of(book.total);
    const drawing::Area lost{bars_begin, y - 15, swallowed * scale, 30};
    svg.frame(lost, {black, 2, "5 4"});
    svg.text({lost.right() + 12, y}, per_cent(swallowed) + ", in glass; counted as it would have arrived",
             {20, black, true, Anchor::start});
    y += step;
    Colour dropped{0};
    int count = 0;
    for (const auto& [how, rays] : book.dropped)
        if (how.second == Reason::depth || how.second == Reason::weight) {
            dropped += rays.weight;
            count += rays.count;
        }
    svg.text({bars_begin - 14, y}, "dropped", {20, black, false, Anchor::end});
    svg.text({bars_begin, y},
             std::to_string(count) + " rays: together the weight of " +
                 digits(largest_component(dropped) * width * lines, 1) + " of " +
                 std::to_string(width * lines) + " pixels",
             {20, black, true, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
