#include "exercises/grader/ray_paths.hpp"

#include "exercises/grader/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rayscope::exercises {
namespace {

constexpr double border = 24, most_height = 320;
constexpr std::size_t most_rays = 40; // more are no picture

bool is_finite(const Vec3d& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

struct Step {
    Vec3d from{0}, to{0};
    bool ends = false; ///< at a hit; else it goes on for ever in the direction of `to`, one unit away
};

std::vector<Step> steps_of(const Trace& trace) {
    std::vector<Step> steps;
    for (const TracedRay& ray : trace.rays) {
        const RaySpawned& start = ray.start();
        if (start.kind == RayKind::shadow || steps.size() == most_rays) continue;
        const auto* hit = ray.find<BoundaryChosen>();
        const Vec3d to = hit != nullptr ? hit->point : start.origin + normalized(start.direction);
        if (is_finite(start.origin) && is_finite(to)) steps.push_back({start.origin, to, hit != nullptr});
    }
    return steps;
}

struct Place {
    double x = 0, y = 0;
};

/// The plane of the first ray and of what turns away from it first.
class Plane {
public:
    Plane(const std::vector<Step>& right, const std::vector<Step>& yours) {
        origin_ = right.front().from;
        along_ = normalized(right.front().to - origin_);
        const Vec3d any = std::abs(along_.z) < 0.9 ? Vec3d(0, 0, 1) : Vec3d(0, 1, 0);
        up_ = normalized(any - dot(any, along_) * along_);
        for (const auto* steps : {&right, &yours})
            for (const Step& step : *steps) {
                const Vec3d way = step.to - step.from;
                const Vec3d off = way - dot(way, along_) * along_;
                if (length(off) < 0.01 * length(way)) continue;
                up_ = normalized(off);
                return;
            }
    }
    [[nodiscard]] Place operator()(const Vec3d& p) const {
        return {dot(p - origin_, along_), -dot(p - origin_, up_)};
    }

private:
    Vec3d origin_, along_, up_;
};

/// A step in the plane, what goes on for ever cut off.
struct Line {
    Place from, to;
    bool ends = false;
};

struct Drawing {
    std::vector<Line> right, yours;
    Place low, high;
};

Drawing drawing_of(const std::vector<Step>& right, const std::vector<Step>& yours) {
    const Plane plane(right, yours);
    Drawing drawing;
    drawing.low = drawing.high = plane(right.front().from);
    const auto hold = [&](const Place& p) {
        drawing.low = {std::min(drawing.low.x, p.x), std::min(drawing.low.y, p.y)};
        drawing.high = {std::max(drawing.high.x, p.x), std::max(drawing.high.y, p.y)};
    };
    for (const auto* steps : {&right, &yours})
        for (const Step& step : *steps) hold(plane(step.from)), hold(plane(step.ends ? step.to : step.from));
    const double size =
        std::max(drawing.high.x - drawing.low.x, drawing.high.y - drawing.low.y); // of what ends
    const double rest = size > 0 ? 0.4 * size : 1;
    const auto add = [&](const std::vector<Step>& steps, std::vector<Line>& lines) {
        for (const Step& step : steps) {
            const Vec3d to = step.ends ? step.to : step.from + rest * (step.to - step.from);
            lines.push_back({plane(step.from), plane(to), step.ends});
            hold(lines.back().to);
        }
    };
    add(right, drawing.right);
    add(yours, drawing.yours);
    return drawing;
}

std::string lines_text(const std::vector<Line>& lines, const Drawing& drawing, double scale,
                       const char* whose) {
    const auto x = [&](const Place& p) { return border + scale * (p.x - drawing.low.x); };
    const auto y = [&](const Place& p) { return border + scale * (p.y - drawing.low.y); };
    std::string svg;
    for (const Line& line : lines) {
        svg += fmt::format("<line class=\"{}\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n",
                           whose, x(line.from), y(line.from), x(line.to), y(line.to));
        if (line.ends)
            svg += fmt::format("<circle class=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\"/>\n", whose,
                               x(line.to), y(line.to));
    }
    return svg;
}

} // namespace

std::string drawn_paths(const Trace& right, const Trace* yours) {
    const std::vector<Step> right_steps = steps_of(right);
    if (right_steps.empty()) return "";
    const Drawing drawing =
        drawing_of(right_steps, yours != nullptr ? steps_of(*yours) : std::vector<Step>());
    const double wide = std::max(drawing.high.x - drawing.low.x, 1e-300),
                 high = drawing.high.y - drawing.low.y;
    const double scale = std::min((drawing_width - 2 * border) / wide,
                                  high > 0 ? (most_height - 2 * border) / high : infinity<double>);
    return fmt::format("<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"the way of the ray\">\n",
                       drawing_width, 2 * border + scale * high) +
           lines_text(drawing.right, drawing, scale, "right") +
           lines_text(drawing.yours, drawing, scale, "yours") + "</svg>\n";
}

} // namespace rayscope::exercises
