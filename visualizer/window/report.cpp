#include "visualizer/window/main_window.hpp"
#include "visualizer/window/memory.hpp"
#include "visualizer/window/script.hpp"

#include <nlohmann/json.hpp>

namespace rayscope::window {
namespace {

std::string text_of(const QString& text) { return text.toStdString(); }

nlohmann::json lanes_json(const MainWindow& window) {
    nlohmann::json lanes = nlohmann::json::array();
    const auto sweep = window.lanes.sweep();
    const auto inside = window.lanes.inside_at(sweep.value_or(0));
    for (std::size_t i = 0; i < inside.size(); ++i) {
        nlohmann::json spans = nlohmann::json::array();
        for (const SpanFound& span : window.lanes.lanes().shown[i].spans)
            spans.push_back({number_json(span.enter.t), number_json(span.exit.t)});
        lanes.push_back({{"label", inside[i].label}, {"spans", spans}});
        if (sweep) lanes.back()["inside"] = inside[i].inside;
    }
    return lanes;
}

nlohmann::json vector_json(const Vec3d& v) { return {number_json(v.x), number_json(v.y), number_json(v.z)}; }

/// Where things are that can be dragged.
nlohmann::json handles_json(const MainWindow& window) {
    nlohmann::json handles = nlohmann::json::object();
    for (const Handle& handle : window.space.handles()) handles[handle.name] = vector_json(handle.at);
    handles["start"] = vector_json(window.desk.trace().rays.front().start().origin); // perhaps out of sight
    return handles;
}

/// What the octree's picture shows, in numbers.
nlohmann::json octree_json(const MainWindow& window) {
    const auto& facts = window.octree.chart.facts();
    if (!facts) return nullptr;
    const int level = window.octree.chart.level();
    nlohmann::json result{{"level", level},
                          {"levels", window.octree.levels.maximum()},
                          {"objects", facts->objects},
                          {"objects_tested", facts->tested}};
    for (std::size_t i = 0; i < fate_names.size(); ++i)
        result[fate_names[i]] = facts->count_to(CellFate(i), level);
    result["held"] = facts->held_counts(level);
    return result;
}

} // namespace

std::string report_of(MainWindow& window, const Outcome& outcome) {
    nlohmann::json row = nlohmann::json::array(), card = nlohmann::json::object(),
                   values = nlohmann::json::array();
    for (const QString& text : window.tree.current_row()) row.push_back(text_of(text));
    for (const CardView::Line& l : window.card.lines()) card[text_of(l.name)] = text_of(l.value);
    for (const QString& text : window.materials.values()) values.push_back(text_of(text));
    const TraceSource& source = window.desk.trace().source;
    const MadeImage& image = window.image.image();
    const nlohmann::json report{
        {"command", outcome.line},
        {"ok", outcome.ok},
        {"message", text_of(window.message())},
        {"state", state_json(window.desk.walk())},
        {"scene", window.desk.file().string()},
        {"changed", window.desk.changed()},
        {"pixel", source.by_hand ? nlohmann::json() : nlohmann::json{source.x, source.y}},
        {"rays", window.shown().rays.size()},
        {"row", row},
        {"left_out", window.tree.left_out()},
        {"not_followed", window.tree.not_followed()},
        {"stops", text_of(window.stops())},
        {"found_shown", window.image.found_shown()},
        {"place", text_of(window.place())},
        {"pixel_text", text_of(window.pixel())},
        {"octree", octree_json(window)},
        {"colours", text_of(window.colours.toPlainText())},
        {"details", text_of(window.details.toPlainText())},
        {"lanes", lanes_json(window)},
        {"sweep", window.lanes.sweep() ? number_json(*window.lanes.sweep()) : nlohmann::json()},
        {"card", card},
        {"materials", values},
        {"console", text_of(window.console.log()).substr(0, 20000)},
        {"image",
         {{"width", image.width},
          {"height", image.height},
          {"fine", image.fine},
          {"seconds", image.seconds}}},
        {"handles", handles_json(window)},
        {"space", {{"rays", window.space.rays_drawn()}, {"surfaces", window.space.surfaces_shown()}}},
        {"size", {window.width(), window.height()}},
        {"milliseconds", outcome.milliseconds},
        {"megabytes", resident_memory()}};
    return report.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace rayscope::window
