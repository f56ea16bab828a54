// The recursion at a glance.

#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

#include <vector>

namespace rayscope::cli {
namespace {

constexpr std::size_t deepest_indent = 12; // levels; deeper ones are drawn at this one and say their depth

std::string what_shadow_met(const Trace& trace, const TracedRay& ray, const Numbers& number) {
    const auto* end = ray.find<RayFinished>();
    const std::string light = "to light " + light_name(trace, ray.start().light) + ": ";
    if (end == nullptr) return light + "not recorded to its end";
    if (end->colour == Colour{1}) return light + "free";
    if (end->colour != Colour{0} || ray.find<BlockerPassed>() != nullptr)
        return light + "dimmed to " + number.colour(end->colour);
    Id blocker = none; // the search ends at the object that blocks
    for (const Event& event : ray.events)
        if (const auto* accepted = std::get_if<ObjectAccepted>(&event)) blocker = accepted->object;
    return light + "blocked by " + object_name(trace, blocker);
}

std::string what_happened(const Trace& trace, const TracedRay& ray, const Numbers& number) {
    if (ray.start().kind == RayKind::shadow) return what_shadow_met(trace, ray, number);
    if (ray.find<Missed>() != nullptr) return "misses everything: background";
    const auto* hit = ray.find<BoundaryChosen>();
    if (hit == nullptr) return "not recorded to its end";
    const bool passes = ray.find<Refracted>() != nullptr;
    const char* verb = ray.find<TotallyReflected>() != nullptr ? "is totally reflected at "
                       : !passes                               ? "meets "
                       : hit->entering                         ? "enters "
                                                               : "leaves ";
    return verb + object_name(trace, hit->object) + " at t" + glue + "=" + glue + number(hit->boundary.t);
}

/// A limit of the recursion that kept a ray from being followed; what a material does not do is no news here.
std::string limit_of(const NotSpawned& refused) {
    switch (refused.reason) {
    case Reason::depth: return "max_depth reached";
    case Reason::weight: return "weight too small";
    case Reason::ray_limit: return "max_rays spent";
    default: return "";
    }
}

class Tree {
public:
    Tree(Page& page, const Trace& trace, const StepStyle& style, int current)
        : page_(page), trace_(trace), style_(style), current_(current) {}

    /// Depth first with a stack of its own: in a trace from a file, the tree may be a chain of any length.
    void add() {
        struct Step {
            int ray;
            std::string prefix;
            bool last;
            std::size_t level;
        };
        std::vector<Step> open{{0, "", true, 0}};
        while (!open.empty()) {
            const Step step = std::move(open.back());
            open.pop_back();
            const TracedRay& ray = trace_.rays[std::size_t(step.ray)];
            std::vector<std::string> limits;
            for (const Event& event : ray.events)
                if (const auto* refused = std::get_if<NotSpawned>(&event);
                    refused && !limit_of(*refused).empty())
                    limits.push_back(std::string("no ") + name_of(refused->kind) +
                                     " ray: " + limit_of(*refused));
            const bool root = step.level == 0;
            const std::string below = root ? "" : step.prefix + (step.last ? "   " : "│  ");
            const bool leaf = ray.children.empty() && limits.empty();
            const std::string first = root ? "" : step.prefix + (step.last ? "└─ " : "├─ ");
            page_.line(first, below + (leaf ? "       " : "│      "), label(step.ray));
            for (std::size_t i = 0; i < limits.size(); ++i) {
                const bool ends = ray.children.empty() && i + 1 == limits.size();
                page_.line(below + (ends ? "└─ " : "├─ "), below + "   ", style_.paint.dim(limits[i]));
            }
            const std::string prefix = step.level < deepest_indent ? below : step.prefix;
            for (auto child = ray.children.rbegin(); child != ray.children.rend(); ++child)
                open.push_back({*child, prefix, child == ray.children.rbegin(), step.level + 1});
        }
    }

private:
    [[nodiscard]] std::string label(int index) const {
        const TracedRay& ray = trace_.rays[std::size_t(index)];
        const RaySpawned& start = ray.start();
        std::string text = std::to_string(index) + glue + name_of(start.kind);
        text = style_.paint.kind(start.kind, text);
        if (start.depth > int(deepest_indent)) text += " depth " + std::to_string(start.depth) + ",";
        if (start.kind == RayKind::reflected || start.kind == RayKind::refracted)
            text += " weight" + std::string(glue) + style_.number(weight(ray)) + ",";
        text += " " + what_happened(trace_, ray, style_.number);
        return index == current_ ? text + " " + style_.paint.bold("◄") : text;
    }

    Page& page_;
    const Trace& trace_;
    const StepStyle& style_;
    int current_;
};

} // namespace

std::string ray_summary(const Trace& trace, int ray, const Numbers& number) {
    return what_happened(trace, trace.rays[std::size_t(ray)], number);
}

std::string tree_text(const Trace& trace, const StepStyle& style, int current) {
    Page page(style.paint);
    const std::size_t count = trace.rays.size();
    page.line(style.paint.bold("The recursion: " + std::to_string(count) + (count == 1 ? " ray" : " rays")));
    Tree(page, trace, style, current).add();
    if (trace.events_dropped > 0)
        page.line("The record was full: " + std::to_string(trace.events_dropped) +
                  " events are missing, the tree is cut there.");
    return page.text();
}

} // namespace rayscope::cli
