#include "visualizer/cli/why_text.hpp"

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/ray_facts.hpp"

namespace rayscope::cli {
namespace {

constexpr std::size_t most_listed = 12,
                      most_compared = 10000; // names in a message; names a typing error is sought in

std::string nearest_at(double t, const Numbers& number) {
    return "its nearest crossing, t" + std::string(glue) + "=" + glue + number(t) + ",";
}

std::string at(double t, const Numbers& number) {
    return "at t" + std::string(glue) + "=" + glue + number(t);
}

std::string behind_text(bool starts_on, double t, const Numbers& number) {
    if (starts_on) return "the ray starts on it, and no crossing lies ahead";
    return "all its crossings lie behind the ray's origin, the last " + at(t, number);
}

/// By how much the line misses it; of a compound, what it does with each part.
std::string passing_text(const Scene& scene, std::size_t object, const RaySpawned& start,
                         const Numbers& number) {
    constexpr std::size_t most = 6;
    const auto all = passings(scene, object, {start.origin, start.direction}, most);
    std::string text;
    for (const Passing& passing : all) {
        text += text.empty() ? ": " : "; ";
        if (scene.drawn[object].is_compound) text += harmless(generic_title(scene, passing.generic)) + " ";
        text += passing.outside < 0 ? "is crossed"
                                    : "at its nearest, " + at(passing.t, number) + ", it is " +
                                          number(passing.outside) + " outside";
    }
    return text.empty() ? text : text + " (in the shape's own units)";
}

/// What the ray did with an object that was not rejected.
std::string accepted_text(const Trace& trace, const TracedRay& ray, const std::string& name, double t,
                          const Numbers& number) {
    if (ray.start().kind == RayKind::shadow) return "it stands in the light's way, " + at(t, number);
    const auto* hit = ray.find<BoundaryChosen>();
    if (hit == nullptr) return "not recorded, but " + nearest_at(t, number) + " lies ahead";
    const std::string& met = trace.objects[std::size_t(hit->object)].name;
    if (met == name) return "the ray does end on it, " + at(t, number);
    return nearest_at(t, number) + " coincides with the hit on " + harmless(met);
}

} // namespace

std::size_t find_drawn(const Scene& scene, const std::string& name) {
    if (name.empty()) throw UsageError("expected the name of a drawn object");
    std::vector<std::string> titles;
    for (std::size_t i = 0; i < scene.drawn.size(); ++i) {
        std::string title = object_title(scene, scene.drawn[i]);
        if (title == name) return i;
        if (titles.size() < most_compared) titles.push_back(harmless(title));
    }
    const std::vector<std::string_view> names(titles.begin(), titles.end());
    const std::string near = did_you_mean(name, names);
    const bool few = !names.empty() && names.size() <= most_listed;
    throw UsageError("no object " + in_quotes(name) + " is drawn" +
                     (near.empty() && few ? "; expected " + one_of(names) : near));
}

std::string why_text(const Workbench& bench, const Trace& trace, int index, std::size_t object,
                     const Numbers& number) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const RaySpawned& start = ray.start();
    const std::string name = object_title(bench.scene, bench.scene.drawn[object]);
    const WhyNot why = why_not(bench, trace, std::size_t(index), object);
    if (why.reason != WhyNot::Reason::line_misses && why.t == infinity<double>)
        return harmless(name) + ": the ray is inside it from its start, and never leaves it";
    std::string reason;
    switch (why.reason) {
    case WhyNot::Reason::line_misses:
        reason = "the ray's line misses it" + passing_text(bench.scene, object, start, number);
        break;
    case WhyNot::Reason::behind: {
        const bool starts_on =
            start.left_object != none && trace.objects[std::size_t(start.left_object)].name == name;
        reason = behind_text(starts_on, why.t, number);
        break;
    }
    case WhyNot::Reason::beyond_reach:
        reason = nearest_at(why.t, number) + " lies behind the light " + at(start.reach, number);
        break;
    case WhyNot::Reason::farther:
        reason = nearest_at(why.t, number) + " lies behind the hit " +
                 at(ray.find<BoundaryChosen>()->boundary.t, number);
        break;
    case WhyNot::Reason::accepted: reason = accepted_text(trace, ray, name, why.t, number); break;
    }
    return harmless(name) + ": " + reason;
}

std::string why_list(const Workbench& bench, const Trace& trace, std::size_t object, const StepStyle& style) {
    constexpr std::size_t sentences = 20; // the column where they begin
    Page page(style.paint);
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const RayKind kind = trace.rays[i].start().kind;
        const std::string label = "ray " + std::to_string(i) + ", " + name_of(kind);
        const std::size_t used = columns(label);
        page.line(style.paint.kind(kind, label) + std::string(used < sentences ? sentences - used : 1, ' '),
                  std::string(sentences, ' '), why_text(bench, trace, int(i), object, style.number));
    }
    return page.text();
}

} // namespace rayscope::cli
