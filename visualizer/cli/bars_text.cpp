#include "visualizer/cli/bars_text.hpp"

#include "visualizer/cli/ray_facts.hpp"

#include <algorithm>

namespace rayscope::cli {
namespace {

constexpr std::size_t label_width = 22, most_lanes = 60;
constexpr double far_behind = 8; // walls that many times farther than the end would squeeze what matters

struct Lane {
    std::string label;
    bool root;
    std::vector<SpanFound> spans;
};

std::string fitted(const std::string& text, std::size_t width) {
    const std::size_t used = columns(text);
    if (used <= width) return text + std::string(width - used, ' ');
    std::string cut;
    std::size_t kept = 0;
    for (std::size_t at = 0; at < text.size() && kept + 1 < width; ++kept) {
        const std::size_t length = std::max<std::size_t>(1, utf8_length(std::string_view(text).substr(at)));
        cut += text.substr(at, length);
        at += length;
    }
    return cut + "…";
}

/// As they were evaluated, each compound's root last; shown with the root first.
std::vector<Lane> lanes_of(const Trace& trace, const TracedRay& ray) {
    std::vector<Lane> lanes;
    std::size_t first = 0; // of the object that is under way
    Id object = none;
    for (std::size_t i = 0; i < ray.events.size(); ++i) {
        const auto* node = std::get_if<NodeEvaluated>(&ray.events[i]);
        if (node == nullptr) continue;
        if (node->object != object) first = lanes.size();
        object = node->object;
        const TraceObject& whole = trace.objects[std::size_t(object)];
        const bool root = std::size_t(node->node) + 1 == whole.nodes.size();
        const std::string name = harmless(root ? whole.name : whole.nodes[std::size_t(node->node)].name);
        lanes.push_back({root ? name : "  " + name, root, spans_after(ray, i)});
        if (!root) continue;
        std::rotate(lanes.begin() + std::ptrdiff_t(first), lanes.end() - 1, lanes.end());
        object = none;
    }
    return lanes;
}

class Axis {
public:
    Axis(const std::vector<Lane>& lanes, std::optional<double> end) {
        double near = infinity<double>;
        for_each_end(lanes, [&](double t) { near = std::min(near, t); });
        if (end && *end > 0) near = *end;
        if (near == infinity<double>) near = 1;
        high_ = near;
        for_each_end(lanes, [&](double t) {
            if (t <= far_behind * near) high_ = std::max(high_, t);
        });
        low_ = -0.04 * high_;
        high_ *= 1.06;
    }

    static constexpr std::size_t width = page_width - label_width - 3;
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }
    /// The left edge of a column, in t.
    [[nodiscard]] double edge(std::size_t column) const {
        return low_ + (high_ - low_) * double(column) / double(width);
    }
    [[nodiscard]] std::optional<std::size_t> column(double t) const {
        if (!(t >= low_ && t < high_)) return std::nullopt;
        return std::min(width - 1, std::size_t((t - low_) / (high_ - low_) * double(width)));
    }

private:
    template <typename Use> static void for_each_end(const std::vector<Lane>& lanes, const Use& use) {
        for (const Lane& lane : lanes)
            for (const SpanFound& span : lane.spans)
                for (const double t : {span.enter.t, span.exit.t})
                    if (t > 0 && std::isfinite(t)) use(t);
    }
    double low_ = 0, high_ = 1;
};

/// Which share of a column the spans cover decides its block; what is thinner than an eighth still shows.
std::string bar(const std::vector<SpanFound>& spans, const Axis& axis) {
    std::string text;
    for (std::size_t column = 0; column < Axis::width; ++column) {
        const double from = axis.edge(column), to = axis.edge(column + 1);
        double covered = 0;
        bool touched = false, at_left = false;
        for (const SpanFound& span : spans) {
            const double a = std::max(from, span.enter.t), b = std::min(to, span.exit.t);
            if (b < a || (b == a && span.enter.t != span.exit.t)) continue;
            touched = true;
            at_left = at_left || a == from;
            covered += (b - a) / (to - from);
        }
        const bool half = covered < 0.75 && covered >= 0.125;
        text += covered >= 0.75       ? "█"
                : half                ? (at_left ? "▌" : "▐")
                : touched             ? "│"
                : from <= 0 && to > 0 ? "┆"
                                      : "·";
    }
    return text;
}

bool inside(const std::vector<SpanFound>& spans, double t) {
    return std::ranges::any_of(spans, [&](const SpanFound& s) { return s.enter.t < t && t < s.exit.t; });
}

std::string scale(const Axis& axis, const Numbers& number) {
    std::string text = fitted("t", label_width);
    std::size_t used = 0;
    for (std::size_t tick = 0; tick <= 4; ++tick) {
        const std::size_t column = tick * (Axis::width - 1) / 4;
        const std::string label = number(axis.edge(column));
        const std::size_t begin = std::min(column, Axis::width - std::min(Axis::width, columns(label)));
        if (begin < used + (tick == 0 ? 0 : 1)) continue;
        text += std::string(begin - used, ' ') + label;
        used = begin + columns(label);
    }
    return text;
}

std::string marked(const Axis& axis, double t, const char* mark, const std::string& label) {
    const auto column = axis.column(t);
    if (!column) return "";
    const std::string text = " " + label;
    const bool left = *column + 1 + columns(text) > Axis::width;
    const std::size_t before = left && *column > columns(text) ? *column - columns(text) : *column;
    return std::string(label_width + before, ' ') + (left ? label + " " + mark : mark + text) + "\n";
}

} // namespace

std::string bars_text(const Trace& trace, int index, std::optional<double> sweep, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    std::vector<Lane> lanes = lanes_of(trace, ray);
    Page page(style.paint);
    page.heading("Inside intervals along ray " + std::to_string(index));
    if (lanes.empty()) {
        page.line("The line meets nothing.", 2);
        return page.text();
    }
    const std::size_t hidden = lanes.size() > most_lanes ? lanes.size() - most_lanes : 0;
    lanes.resize(lanes.size() - hidden);
    const std::optional<double> end = end_of(ray);
    const Axis axis(lanes, end);
    const Numbers short_number(4);
    std::string text = page.text();
    if (sweep) text += marked(axis, *sweep, "▼", "t = " + style.number(*sweep));
    for (const Lane& lane : lanes) {
        const std::string label = fitted(lane.label, label_width);
        text += (lane.root ? style.paint.bold(label) : label) + bar(lane.spans, axis);
        if (sweep) text += inside(lane.spans, *sweep) ? " in" : " – ";
        text += "\n";
    }
    text += scale(axis, short_number) + "\n";
    if (end && std::isfinite(*end))
        text += marked(axis, *end, "▲", "the ray ends, t = " + style.number(*end));
    if (hidden > 0) text += "… and " + std::to_string(hidden) + " more lanes\n";
    return text;
}

} // namespace rayscope::cli
