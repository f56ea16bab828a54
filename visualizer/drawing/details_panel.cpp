#include "visualizer/drawing/details_panel.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/text.hpp"

#include <algorithm>
#include <cstdio>

namespace rayscope::drawing {
namespace {

constexpr double line = 1.45;

std::string triple(const Vec3d& v) {
    std::string text;
    for (int i = 0; i < 3; ++i) {
        const std::string part = number(v[i], 4);
        text += std::string(part.size() < 10 ? 10 - part.size() : 1, ' ') + part;
    }
    return text;
}

std::string rgb(const Colour& c) { return number(c.r, 3) + "  " + number(c.g, 3) + "  " + number(c.b, 3); }

const char* reason_text(Reason reason) {
    switch (reason) {
    case Reason::coefficient_zero: return "coefficient 0";
    case Reason::depth: return "depth limit";
    case Reason::weight: return "weight too small";
    case Reason::total_internal_reflection: return "total reflection";
    case Reason::ray_limit: return "ray limit";
    case Reason::leaves_solid: return "leaves the solid";
    }
    return "";
}

const char* reason_text(SearchEnd reason) {
    switch (reason) {
    case SearchEnd::nothing_left: return "no place left";
    case SearchEnd::beyond_reach: return "the rest is beyond";
    case SearchEnd::blocked: return "blocked";
    case SearchEnd::covered: return "cell covered";
    }
    return "";
}

class Collector {
public:
    Collector(const Trace& trace, const TracedRay& ray) : trace_(trace), ray_(ray) {}

    std::vector<Detail> lines;

    void add(std::string name, std::string value) {
        lines.push_back({std::move(name), std::move(value), {}});
    }

    void operator()(const SearchBegan& e) { stage_ = std::string(name_of(e.stage)); }
    void operator()(const SearchEnded& e) {
        add(stage_, std::to_string(e.places) + (e.places == 1 ? " place, " : " places, ") +
                        std::to_string(e.tested) + (e.tested == 1 ? " test, " : " tests, ") +
                        std::to_string(e.spared) + " saved");
        add("ended", reason_text(e.reason));
    }
    void operator()(const BoundaryChosen& e) {
        add("hit", object_name(trace_, e.object) + (e.entering ? " (enters)" : " (leaves)"));
        std::string t = number(e.boundary.t, 7);
        if (e.error_bound > 0) t += " ± " + number(e.error_bound, 2);
        add("t", t);
        add("point", triple(e.point));
        add("normal", triple(e.normal));
        if (e.medium_from == e.medium_to && e.speed_from == e.speed_to) return;
        add("media", medium_name(trace_, e.medium_from) + " → " + medium_name(trace_, e.medium_to) + ",  n " +
                         number(1 / e.speed_from, 4) + " → " + number(1 / e.speed_to, 4));
    }
    void operator()(const Missed&) { add("hit", "nothing: background"); }
    void operator()(const Reflected& e) {
        if (ray_.find<Refracted>() == nullptr && ray_.find<TotallyReflected>() == nullptr)
            add("angle", "θ = " + degrees(e.theta));
    }
    void operator()(const Refracted& e) {
        add("angles", "θ₁ " + degrees(e.theta_from) + " → θ₂ " + degrees(e.theta_to));
        if (!std::isnan(e.critical)) add("critical", degrees(e.critical) + " (not reached)");
    }
    void operator()(const TotallyReflected& e) {
        add("angles", "θ₁ " + degrees(e.theta_from) + ": total reflection");
        add("critical", degrees(e.critical) + " (exceeded)");
    }
    void operator()(const NotSpawned& e) {
        if (e.reason == Reason::coefficient_zero || e.reason == Reason::total_internal_reflection) return;
        add("cut off", std::string(kind_name(e.kind)) + ": " + reason_text(e.reason));
    }
    void operator()(const RayFinished& e) {
        const bool shadow = ray_.start().kind == RayKind::shadow;
        lines.push_back({shadow ? "visible" : "colour", rgb(e.colour), e.colour});
    }
    void operator()(const auto&) {}

private:
    const Trace& trace_;
    const TracedRay& ray_;
    std::string stage_;
};

} // namespace

std::vector<Detail> details_of(const Trace& trace, int id) {
    const TracedRay& ray = trace.rays[std::size_t(id)];
    const RaySpawned& start = ray.start();
    Collector collect(trace, ray);
    collect.add("depth", std::to_string(start.depth) +
                             (ray.parent == none ? "" : ",  parent ray " + std::to_string(ray.parent)));
    collect.add("weight", number(weight(ray), 4));
    collect.add("origin", triple(start.origin));
    collect.add("direction", triple(start.direction));
    if (const double size = length(start.direction); std::abs(size - 1) > 1e-9)
        collect.add("|d|", number(size, 6));
    if (start.kind == RayKind::shadow) {
        collect.add(is_blocked(ray) ? "blocked by" : "reaches", target_name(trace, ray));
        collect.add("t", number(drawn_end(ray, infinity<double>).t, 7));
    }
    for (const Event& event : ray.events) std::visit(collect, event);
    return collect.lines;
}

double details_height(std::size_t lines, double font) { return font * (line * double(lines) + 6.4); }

void draw_details(Canvas& canvas, const Area& area, const Trace& trace, int id, double font) {
    const TracedRay& ray = trace.rays[std::size_t(id)];
    const double left = area.x + font * 0.9, right = area.right() - font * 0.8;
    canvas.add(Stroke{{{area.x, area.y}, {area.right(), area.y}}, hair, 1});
    const double title_y = area.y + font * 1.2;
    canvas.add(Stroke{{{left, title_y}, {left + font * 1.6, title_y}},
                      ray_colour(ray),
                      3,
                      ray.start().kind == RayKind::shadow});
    canvas.add(Text{{left + font * 2.1, title_y},
                    "Ray " + std::to_string(id) + ": " + kind_name(ray.start().kind),
                    font * 1.08,
                    ray_text_colour(ray),
                    Font::bold});

    const double foot = area.bottom() - font * 2.6;
    const double value_x = left + font * 5.4;
    double y = area.y + font * 2.9;
    std::vector<Detail> lines = details_of(trace, id);
    const std::size_t fit = std::size_t(std::max((foot - font * 0.6 - y) / (font * line) + 0.5, 0.0));
    // Where not all fits, the colour, which comes last, stays.
    if (lines.size() > fit && fit > 0) lines.erase(lines.begin() + std::ptrdiff_t(fit) - 1, lines.end() - 1);
    for (const Detail& detail : lines) {
        canvas.add(Text{{left, y}, elided(detail.name, Font::sans, font, font * 5.2), font, quiet_ink});
        double x = value_x;
        if (detail.swatch) {
            const Area swatch{x, y - font * 0.5, font * 1.8, font};
            canvas.add(
                FilledArea{{swatch.x - 1, swatch.y - 1, swatch.width + 2, swatch.height + 2}, quiet_ink});
            canvas.add(FilledArea{swatch, on_screen(*detail.swatch)});
            x += font * 2.4;
        }
        const bool vector = detail.value.starts_with(' ');
        const Font face = vector ? Font::mono : Font::sans;
        const double size = vector ? font * 0.95 : font;
        canvas.add(Text{{x, y},
                        elided(vector ? detail.value.substr(1) : detail.value, face, size, right - x),
                        size,
                        ink,
                        face});
        y += font * line;
    }

    canvas.add(Stroke{{{area.x, foot}, {area.right(), foot}}, hair, 1});
    const double middle = (foot + area.bottom()) / 2;
    const std::string name = trace.source.by_hand ? "Ray's colour" : "Pixel";
    canvas.add(Text{{left, middle}, name, font, ink, Font::bold});
    const double swatch_x = left + text_width(name, Font::bold, font) + font * 0.8;
    const Area swatch{swatch_x, middle - font * 0.8, font * 3.4, font * 1.6};
    canvas.add(FilledArea{{swatch.x - 1, swatch.y - 1, swatch.width + 2, swatch.height + 2}, quiet_ink});
    canvas.add(FilledArea{swatch, on_screen(trace.colour)});
    const double text_x = swatch.right() + font * 0.8;
    canvas.add(Text{{text_x, middle},
                    elided(rgb(trace.colour) + "  linear RGB", Font::sans, font, right - text_x),
                    font,
                    ink});
}

} // namespace rayscope::drawing
