#include "exercises/grader/ray_lanes.hpp"

#include "exercises/grader/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rayscope::exercises {
namespace {

constexpr double bar_height = 10, lane_height = 2 * bar_height + 10, margin = 90;

struct Lane {
    std::string object;
    std::vector<SpanFound> right, yours;
};

/// The spans of each whole object, not of its parts, on the line of the first ray.
template <typename Add> void for_each_object(const Trace& trace, const Add& add) {
    const TracedRay& ray = trace.rays.front();
    for (std::size_t i = 0; i < ray.events.size(); ++i)
        if (const auto* found = std::get_if<NodeEvaluated>(&ray.events[i])) {
            const TraceObject& object = trace.objects[std::size_t(found->object)];
            if (std::size_t(found->node) + 1 == object.nodes.size()) add(object.name, spans_after(ray, i));
        }
}

std::vector<Lane> lanes_of(const Trace& right, const Trace* yours) {
    std::vector<Lane> lanes;
    const auto lane = [&](const std::string& name) -> Lane& {
        const auto found = std::ranges::find(lanes, name, &Lane::object);
        return found != lanes.end() ? *found : lanes.emplace_back(Lane{name, {}, {}});
    };
    for_each_object(right, [&](const std::string& name, auto spans) { lane(name).right = std::move(spans); });
    if (yours != nullptr)
        for_each_object(*yours,
                        [&](const std::string& name, auto spans) { lane(name).yours = std::move(spans); });
    return lanes;
}

/// From t to the place in the drawing.
class TimeScale {
public:
    explicit TimeScale(const std::vector<Lane>& lanes) {
        for (const Lane& lane : lanes)
            for (const auto* list : {&lane.right, &lane.yours})
                for (const SpanFound& span : *list)
                    for (const double t : {span.enter.t, span.exit.t})
                        if (std::isfinite(t)) least_ = std::min(least_, t), most_ = std::max(most_, t);
        const double border = 0.1 * (most_ - least_);
        least_ -= border, most_ += border;
    }
    [[nodiscard]] double operator()(double t) const {
        const double share = (std::clamp(t, least_, most_) - least_) / (most_ - least_);
        return margin + share * (drawing_width - margin - 10);
    }

private:
    double least_ = 0, most_ = 1;
};

std::string bars(const std::vector<SpanFound>& spans, const TimeScale& x, double y, const char* whose) {
    std::string svg;
    for (const SpanFound& span : spans)
        svg += fmt::format("<rect class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\">"
                           "<title>{}: {:.6g} to {:.6g}</title></rect>\n",
                           whose, x(span.enter.t), y, std::max(1.0, x(span.exit.t) - x(span.enter.t)),
                           bar_height, whose, span.enter.t, span.exit.t);
    return svg;
}

} // namespace

std::string drawn_lanes(const Trace& right, const Trace* yours) {
    const std::vector<Lane> lanes = lanes_of(right, yours);
    if (lanes.empty()) return "";
    const TimeScale x(lanes);
    const double height = lane_height * double(lanes.size()), start = x(0);
    std::string svg = fmt::format(
        "<svg viewBox=\"0 0 {0} {1}\" role=\"img\" aria-label=\"where the ray is inside each object\">\n"
        "<line class=\"start\" x1=\"{2:.1f}\" y1=\"0\" x2=\"{2:.1f}\" y2=\"{3}\"/>"
        "<text x=\"{2:.1f}\" y=\"{4}\">t = 0</text>\n",
        drawing_width, height + 18, start, height, height + 14);
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const double y = lane_height * double(i);
        svg += fmt::format("<text x=\"2\" y=\"{:.1f}\">{}</text><line x1=\"{}\" y1=\"{:.1f}\" x2=\"{}\" "
                           "y2=\"{:.1f}\"/>\n",
                           y + 18, in_markup(lanes[i].object), margin, y + lane_height / 2,
                           drawing_width - 10, y + lane_height / 2);
        svg += bars(lanes[i].right, x, y + 4, "right") + bars(lanes[i].yours, x, y + 6 + bar_height, "yours");
    }
    return svg + "</svg>\n";
}

} // namespace rayscope::exercises
