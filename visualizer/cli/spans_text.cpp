// The inside lists of everything that the ray's line meets.

#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace rayscope::cli {
namespace {

constexpr std::size_t spans_column = 38;
constexpr std::size_t most_objects = 24, most_nodes = 40, most_spans = 12; // a person reads no more

/// What the events of one object's test say.
struct ObjectSpans {
    Id object = none;
    std::map<Id, std::vector<SpanFound>> of_node;
    std::vector<ClusterMerged> clusters;
    bool accepted = false;
    double t = 0;
};

std::vector<ObjectSpans> collect(const TracedRay& ray) {
    std::vector<ObjectSpans> found;
    for (std::size_t i = 0; i < ray.events.size(); ++i) {
        if (const auto* node = std::get_if<NodeEvaluated>(&ray.events[i])) {
            const bool same = !found.empty() && found.back().object == node->object;
            if (!same || found.back().of_node.contains(node->node)) found.push_back({node->object, {}, {}});
            found.back().of_node[node->node] = spans_after(ray, i);
        } else if (const auto* cluster = std::get_if<ClusterMerged>(&ray.events[i])) {
            if (!found.empty()) found.back().clusters.push_back(*cluster);
        } else if (const auto* accepted = std::get_if<ObjectAccepted>(&ray.events[i])) {
            if (found.empty() || found.back().object != accepted->object) continue;
            found.back().accepted = true;
            found.back().t = accepted->t;
        }
    }
    return found;
}

std::string interval(const SpanFound& span, const Numbers& number) {
    if (span.enter.t == span.exit.t) return "at" + std::string(glue) + number(span.enter.t);
    return "(" + number(span.enter.t) + "," + glue + number(span.exit.t) + ")";
}

std::string intervals(const std::vector<SpanFound>& spans, const Numbers& number) {
    if (spans.empty()) return "never inside";
    std::string text;
    for (std::size_t i = 0; i < std::min(spans.size(), most_spans); ++i)
        text += (i == 0 ? "" : " ") + interval(spans[i], number);
    if (spans.size() > most_spans) text += " … and " + std::to_string(spans.size() - most_spans) + " more";
    return text;
}

bool is_name(const std::string& text) {
    return std::all_of(text.begin(), text.end(),
                       [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
}

/// "shell = outer − inner" for a named expression; the name alone for leaves and for what is an expression already.
std::string node_title(const TraceObject& object, const TraceNode& node, const std::string& name) {
    const auto operand = [&](Id id) {
        const TraceNode& other = object.nodes[std::size_t(id)];
        const bool plain = other.operation == Operation::leaf || is_name(other.name);
        return plain ? harmless(other.name) : "(" + harmless(other.name) + ")";
    };
    if (!is_name(name)) return harmless(name);
    switch (node.operation) {
    case Operation::leaf: return harmless(name);
    case Operation::complement: return name + " = ¬" + operand(node.left);
    case Operation::set_union: return name + " = " + operand(node.left) + " ∪ " + operand(node.right);
    case Operation::intersection: return name + " = " + operand(node.left) + " ∩ " + operand(node.right);
    case Operation::difference: return name + " = " + operand(node.left) + " − " + operand(node.right);
    }
    return name;
}

/// The author's tree, the root first. The stack is explicit: a chain of 10⁵ operands is as deep as it is long.
void add_nodes(Page& page, const TraceObject& object, const ObjectSpans& spans, const StepStyle& style) {
    struct Step {
        Id node;
        std::string first, below;
    };
    std::vector<Step> open{{Id(object.nodes.size()) - 1, "  ", "  "}};
    std::size_t shown = 0;
    for (; !open.empty() && shown < most_nodes; ++shown) {
        const Step step = std::move(open.back());
        open.pop_back();
        const TraceNode& node = object.nodes[std::size_t(step.node)];
        const bool root = shown == 0;
        const std::string title = node_title(object, node, root ? object.name : node.name);
        const auto found = spans.of_node.find(step.node);
        const std::string list =
            found == spans.of_node.end() ? "not recorded" : intervals(found->second, style.number);
        const std::string left = step.first + (root ? style.paint.bold(title) : title);
        const std::size_t used = columns(left);
        const std::string hanging(spans_column, ' ');
        if (used + 2 <= spans_column)
            page.line(left + std::string(spans_column - used, ' '), hanging, list);
        else {
            page.line(left);
            page.line(hanging, hanging, list);
        }
        if (node.right != none) open.push_back({node.right, step.below + "└─ ", step.below + "   "});
        if (node.left != none) {
            const bool only = node.right == none;
            open.push_back(
                {node.left, step.below + (only ? "└─ " : "├─ "), step.below + (only ? "   " : "│  ")});
        }
    }
    if (!open.empty()) page.line("… and " + std::to_string(object.nodes.size() - shown) + " more nodes", 2);
}

std::string end_text(const char* verb, const Boundary& end, const Trace& trace, const Numbers& number) {
    if (std::isinf(end.t)) return std::string("never ") + verb;
    return std::string(verb) + " at" + glue + number(end.t) + " through " + generic_name_of(trace, end.leaf) +
           (end.flipped ? " (subtracted)" : "");
}

void add_object(Page& page, const Trace& trace, const ObjectSpans& spans, const StepStyle& style) {
    const TraceObject& object = trace.objects[std::size_t(spans.object)];
    add_nodes(page, object, spans, style);
    const auto root = spans.of_node.find(Id(object.nodes.size()) - 1);
    if (object.nodes.size() > 1 && root != spans.of_node.end())
        for (std::size_t i = 0; i < std::min(root->second.size(), most_spans); ++i)
            page.line(end_text("enters", root->second[i].enter, trace, style.number) + ", " +
                          end_text("leaves", root->second[i].exit, trace, style.number),
                      4);
    for (const ClusterMerged& cluster : spans.clusters)
        page.line(std::to_string(cluster.count) + " crossings from t = " + style.number(cluster.t_first) +
                      " to " + style.number(cluster.t_last) +
                      " lie within their error bounds: their number is " +
                      (cluster.kept ? "odd, so one of them stays" : "even, so all of them vanish"),
                  4);
    page.line(spans.accepted
                  ? "first crossing that counts: t" + std::string(glue) + "=" + glue + style.number(spans.t)
                  : "no crossing counts: none lies ahead, within the ray's reach",
              4);
}

} // namespace

void add_spans(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const std::vector<ObjectSpans> met = collect(ray);
    page.heading("Inside lists: for which t the ray's line is inside (t < 0: behind its origin)");
    if (met.empty()) page.line("The line meets nothing.", 2);
    for (std::size_t i = 0; i < std::min(met.size(), most_objects); ++i)
        add_object(page, trace, met[i], style);
    if (met.size() > most_objects)
        page.line("… and " + std::to_string(met.size() - most_objects) + " more objects", 2);
    if (const auto* end = ray.find<RayFinished>(); end != nullptr && end->tested > int(met.size()))
        page.line("Objects tested: " + std::to_string(end->tested) + ". The line misses the others.", 2);
}

} // namespace rayscope::cli
