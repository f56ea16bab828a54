#include "visualizer/page/page.hpp"

#include "visualizer/page/base64.hpp"
#include "visualizer/page/page_parts.hpp"
#include "visualizer/page/surfaces.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rayscope::page {
namespace {

using Json = nlohmann::json;

constexpr std::size_t most_events = 200'000; // some 40 MB, as much as a browser likes
constexpr std::size_t room_of_surfaces =
    220'000; // bytes: with frame and trace of a shipped scene below 400 KB

Json json_of(const Vec3d& v) { return {v.x, v.y, v.z}; }

/// Corners as 16-bit fractions of the box around them: finer than a pixel.
Json json_of(const Surface& surface) {
    Box<double> box;
    for (const Vec3d& p : surface.triangles.corners) box.include(p);
    const Vec3d size = box.high - box.low;
    std::vector<std::uint16_t> corners, triangles;
    for (const Vec3d& p : surface.triangles.corners)
        for (int axis = 0; axis < 3; ++axis) {
            const double share = size[axis] > 0 ? (p[axis] - box.low[axis]) / size[axis] : 0;
            corners.push_back(std::uint16_t(std::lround(std::clamp(share, 0.0, 1.0) * 65535)));
        }
    const bool many = surface.triangles.corners.size() > 65535;
    for (const auto& triangle : surface.triangles.triangles)
        for (const std::uint32_t corner : triangle) {
            triangles.push_back(std::uint16_t(corner & 65535U));
            if (many) triangles.push_back(std::uint16_t(corner >> 16U));
        }
    const bool some = !corners.empty();
    Json json = {{"name", surface.name},
                 {"colour", json_of(surface.colour)},
                 {"clear", surface.clear},
                 {"low", some ? json_of(box.low) : json_of(Vec3d{0})},
                 {"high", some ? json_of(box.high) : json_of(Vec3d{0})},
                 {"corners", base64(corners)},
                 {"triangles", base64(triangles)},
                 {"wide", many}};
    if (surface.flat) json["squares"] = {json_of(surface.u), json_of(surface.v)};
    return json;
}

Json optional_json(const std::optional<double>& number) { return number ? Json(*number) : Json(nullptr); }

Json json_of(const RefractionCard& card) {
    return {{"from", card.medium_from},
            {"to", card.medium_to},
            {"speed_from", card.speed_from},
            {"speed_to", card.speed_to},
            {"eta", card.eta},
            {"theta_from", card.theta_from},
            {"theta_to", optional_json(card.theta_to)},
            {"critical", optional_json(card.critical)},
            {"fresnel", card.fresnel},
            {"schlick", card.schlick},
            {"reflection", largest_component(card.reflection)},
            {"transmission", largest_component(card.transmission)}};
}

Json scene_json(const Workbench& bench, const Trace& trace) {
    const Surroundings around = surroundings_of(bench, trace, room_of_surfaces);
    Json surfaces = Json::array(), cards = Json::array(), moments = Json::array();
    for (const Surface& surface : around.surfaces)
        if (!surface.triangles.triangles.empty()) surfaces.push_back(json_of(surface));
    for (int ray = 0; std::size_t(ray) < trace.rays.size(); ++ray) {
        const auto card = refraction_card(trace, ray);
        cards.push_back(card ? json_of(*card) : Json(nullptr));
    }
    const Timeline timeline(trace);
    for (std::size_t moment = 0; moment < timeline.size(); ++moment) {
        moments.push_back(timeline.at(moment).ray);
        moments.push_back(timeline.at(moment).event);
    }
    const Camera& camera = bench.scene.camera;
    return {{"surfaces", surfaces},
            {"left_out", around.left_out},
            {"centre", json_of(around.shown.centre)},
            {"radius", around.shown.radius},
            {"up", json_of(camera.up)},
            {"cards", cards},
            {"moments", moments}};
}

/// As the content of a script element: no '<' can end it.
std::string embedded(const Json& json) {
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    std::string safe;
    safe.reserve(text.size());
    for (const char c : text)
        if (c == '<')
            safe += "\\u003c";
        else
            safe += c;
    return safe;
}

void check_size(const Trace& trace) {
    std::size_t events = 0;
    for (const TracedRay& ray : trace.rays) events += ray.events.size();
    if (events > most_events)
        throw std::runtime_error(
            "a page holds at most " + std::to_string(most_events) + " events, this trace has " +
            std::to_string(events) +
            ": a smaller max_depth or a larger min_weight gives fewer rays; .json holds all");
}

void replace(std::string& text, std::string_view mark, std::string_view value) {
    text.replace(text.find(mark), mark.size(), value);
}

} // namespace

std::string page_text(const Workbench& bench, const Trace& trace) {
    std::string text(html_part);
    // From the end to the start: what is put in is not looked at again.
    replace(text, "@SCRIPT@", script_part);
    replace(text, "@SCENE@", embedded(scene_json(bench, trace)));
    replace(text, "@TRACE@", embedded(to_json(trace)));
    replace(text, "@STYLE@", style_part);
    return text;
}

void write_page(const Workbench& bench, const Trace& trace, const std::filesystem::path& path) {
    check_size(trace);
    write_text_file(path, page_text(bench, trace));
}

} // namespace rayscope::page
