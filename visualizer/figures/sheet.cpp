#include "visualizer/figures/sheet.hpp"

#include <algorithm>

namespace rayscope::figures {

Workbench apart(const Scene& scene, const std::vector<std::string>& generics) {
    Scene changed = scene;
    changed.drawn.clear();
    for (const std::string& name : generics)
        for (std::size_t i = 0; i < changed.generics.size(); ++i)
            if (changed.generics[i].name == name) {
                if (!changed.generics[i].material) changed.generics[i].material = 0;
                changed.generics[i].visible = true;
                changed.drawn.push_back({false, i});
            }
    if (changed.drawn.size() != generics.size())
        throw InputError(scene.file, {}, "a figure asks for a generic that is not there");
    return make_workbench(std::move(changed));
}

std::size_t drawn_called(const Scene& scene, const std::string& name) {
    for (std::size_t i = 0; i < scene.drawn.size(); ++i)
        if (object_title(scene, scene.drawn[i]) == name) return i;
    throw InputError(scene.file, {}, "a figure asks for '" + name + "', which is not drawn");
}

List list_of(const Workbench& bench, const Ray<double>& ray, std::size_t drawn) {
    List list;
    const auto all = spans(bench, ray);
    for (const Span<double>& span : all.at(drawn)) list.emplace_back(span.enter.t, span.exit.t);
    return list;
}

List list_of(const Trace& trace, int ray, const std::string& node) {
    const TracedRay& traced = trace.rays.at(std::size_t(ray));
    for (std::size_t i = 0; i < traced.events.size(); ++i) {
        const auto* evaluated = std::get_if<NodeEvaluated>(&traced.events[i]);
        if (evaluated == nullptr) continue;
        const TraceObject& object = trace.objects[std::size_t(evaluated->object)];
        const bool root = std::size_t(evaluated->node) + 1 == object.nodes.size();
        if (object.nodes[std::size_t(evaluated->node)].name != node && !(root && object.name == node))
            continue;
        List list;
        for (const SpanFound& span : spans_after(traced, i)) list.emplace_back(span.enter.t, span.exit.t);
        return list;
    }
    throw InputError(trace.source.scene, {}, "the trace has no inside list of '" + node + "'");
}

} // namespace rayscope::figures
