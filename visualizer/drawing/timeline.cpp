#include "visualizer/drawing/timeline.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/tessellate.hpp"
#include "visualizer/drawing/text.hpp"

#include <algorithm>

namespace rayscope::drawing {
namespace {

/// The t at which the ray stops, if it does.
std::optional<double> stop_of(const TracedRay& ray) {
    const RayEnd end = drawn_end(ray, 1);
    return end.open || !std::isfinite(end.t) ? std::nullopt : std::optional(end.t);
}

std::string stop_text(const TracedRay& ray, double t) {
    const char* what =
        ray.find<BoundaryChosen>() != nullptr ? "hit" : (is_blocked(ray) ? "blocked" : "light");
    return std::string(what) + " t = " + number(t, 6);
}

struct Axis {
    Window window;
    double left, width;

    [[nodiscard]] double at(double t) const {
        const double share = (t - window.low) / (window.high - window.low);
        return left + std::clamp(share, 0.0, 1.0) * width;
    }
};

void draw_ticks(Canvas& canvas, const Axis& axis, double top, double bottom, double font) {
    const auto [low, high] = axis.window;
    const double step = round_size((high - low) * font * 5.2 / axis.width);
    const double largest = std::max(std::abs(low), std::abs(high));
    const int digits = std::clamp(int(std::floor(std::log10(largest / step))) + 2, 3, 15);
    for (double k = std::ceil(low / step); k * step <= high; ++k) {
        const double x = axis.at(k * step);
        canvas.add(Stroke{{{x, top}, {x, bottom + 4}}, hair, 1});
        const Text label{{x, bottom + 4 + font * 0.65},
                         number(k * step, digits),
                         font * 0.92,
                         quiet_ink,
                         Font::sans,
                         Align::centre};
        if (text_area(label).right() < axis.left + axis.width + font * 0.3)
            canvas.add(label); // there stands "t"
    }
}

void draw_bars(Canvas& canvas, const Axis& axis, const Lane& lane, double y, double height) {
    for (const SpanFound& span : lane.spans) {
        const double from = std::max(span.enter.t, axis.window.low),
                     to = std::min(span.exit.t, axis.window.high);
        if (!(to >= from)) continue; // a surface without volume is a tick
        const auto bar = [&](double a, double b, Rgb colour) {
            const double x = axis.at(a);
            canvas.add(FilledArea{{x, y - height / 2, std::max(axis.at(b) - x, 1.5), height}, colour});
        };
        // What lies behind the start is on the ray's line, not on the ray.
        if (from < 0) bar(from, std::min(to, 0.0), mixed(lane.colour, paper, 0.7));
        if (to >= 0) bar(std::max(from, 0.0), to, lane.colour);
        const auto goes_on = [&](double x, double tip) {
            canvas.add(FilledPolygon{{{x, y - height / 2}, {x + tip, y}, {x, y + height / 2}}, lane.colour});
        };
        if (span.exit.t > axis.window.high) goes_on(axis.left + axis.width, height * 0.45);
    }
}

} // namespace

Window timeline_window(const Lanes& lanes, const TracedRay& ray) {
    std::vector<double> times;
    const std::optional<double> stop = stop_of(ray);
    if (stop && *stop > 0) times.push_back(*stop);
    for (const Lane& lane : lanes.shown)
        for (const SpanFound& span : lane.spans)
            for (const double t : {span.enter.t, span.exit.t})
                if (t > 0 && std::isfinite(t)) times.push_back(t);
    if (times.empty()) return {};
    std::ranges::sort(times);
    // Far walls behind a near hit would squeeze what matters.
    const double near = stop && *stop > 0 ? *stop : times.front();
    double high = near;
    for (const double t : times)
        if (t <= far_behind * near) high = std::max(high, t);
    double low = 0;
    if (times.front() > 0.6 * high && high > times.front() * 1.001)
        low = std::max(0.0, times.front() - 0.35 * (high - times.front()));
    const double span = high - low;
    // A little of what lies behind the start, where the ray may already be inside.
    return {low == 0 ? -0.04 * span : low, high + 0.12 * span};
}

double timeline_height(std::size_t lanes, double font) {
    return font * (1.75 * double(std::max<std::size_t>(lanes, 1)) + 4.6);
}

void draw_timeline(Canvas& canvas, const Area& area, const Lanes& lanes, const Trace& trace, int ray,
                   double font) {
    canvas.add(FilledArea{area, paper});
    canvas.add(Stroke{{{area.x, area.y}, {area.right(), area.y}}, hair, 1});
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    const double pad = font, row = font * 1.75;
    const double title_y = area.y + font * 0.95;
    const std::optional<double> stop = stop_of(traced);
    const std::string mark = stop ? stop_text(traced, *stop) : std::string{};
    const double mark_width = text_width(mark, Font::bold, font);
    std::string title = "Inside intervals along ray " + std::to_string(ray);
    if (lanes.hidden > 0) title += "  (" + std::to_string(lanes.hidden) + " more lanes not shown)";
    title = elided(title, Font::bold, font, area.width - mark_width - 3 * pad);
    canvas.add(Text{{area.x + pad, title_y}, title, font, ink, Font::bold});
    if (lanes.shown.empty()) {
        canvas.add(
            Text{{area.x + pad, area.y + font * 2.8}, "The ray's line meets no object.", font, quiet_ink});
        return;
    }
    const double label_room = std::min(area.width * 0.3, font * 19);
    double widest = 0;
    const auto face = [](const Lane& lane) { return lane.root ? Font::bold : Font::sans; };
    for (const Lane& lane : lanes.shown)
        widest =
            std::max(widest, text_width(elided(lane.label, face(lane), font, label_room), face(lane), font));
    const double left = area.x + pad + widest + font;
    const Axis axis{timeline_window(lanes, traced), left, area.right() - left - 2 * font};
    const double top = area.y + font * 2.5, bottom = top + row * double(lanes.shown.size());
    draw_ticks(canvas, axis, top, bottom, font);
    for (std::size_t i = 0; i < lanes.shown.size(); ++i) {
        const Lane& lane = lanes.shown[i];
        const double y = top + row * (double(i) + 0.5);
        canvas.add(Stroke{{{axis.left, y}, {axis.left + axis.width, y}}, hair, 1});
        draw_bars(canvas, axis, lane, y, row * 0.62);
        canvas.add(Text{{left - font * 0.7, y},
                        elided(lane.label, face(lane), font, label_room),
                        font,
                        lane.root ? ink : mixed(lane.colour, ink, 0.6),
                        face(lane),
                        Align::right});
    }
    canvas.add(Stroke{{{axis.left, bottom}, {axis.left + axis.width, bottom}}, quiet_ink, 1});
    if (axis.window.low < 0) {
        const double x = axis.at(0);
        canvas.add(Stroke{{{x, top - 3}, {x, bottom + 3}}, quiet_ink, 1.2});
    }
    canvas.add(Text{{axis.left + axis.width + font * 0.9, bottom + 4 + font * 0.65},
                    "t",
                    font,
                    ink,
                    Font::bold,
                    Align::centre});
    if (!stop || *stop < axis.window.low || *stop > axis.window.high) return;
    const double x = axis.at(*stop), half = mark_width / 2;
    const Rgb colour = ray_colour(traced);
    canvas.add(Stroke{{{x, top - font * 0.5}, {x, bottom + 3}}, colour, 2.4});
    const double free_from = area.x + 2 * pad + text_width(title, Font::bold, font);
    const double middle = std::max(std::min(x, area.right() - half - pad), free_from + half);
    canvas.add(Text{{middle, title_y}, mark, font, ray_text_colour(traced), Font::bold, Align::centre});
    if (std::abs(middle - x) > half) {
        const double nearest = std::clamp(x, middle - half, middle + half);
        canvas.add(Stroke{{{nearest, title_y + font * 0.7}, {x, top - font * 0.5}}, colour, 1});
    }
}

} // namespace rayscope::drawing
