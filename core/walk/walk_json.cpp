#include "core/walk/walk_json.hpp"

#include "core/trace/trace_json.hpp"

#include <nlohmann/json.hpp>

namespace rayscope {

nlohmann::json state_json(const Walk& walk) {
    const Spot spot = walk.cursor().spot();
    const SeenEvent here = walk.here();
    const auto start = to_json(here.traced().events.front());
    return {{"ray", spot.ray},
            {"event", spot.event},
            {"events", here.traced().events.size()},
            {"moment", walk.cursor().moment()},
            {"moments", walk.timeline().size()},
            {"kind", start["kind"]},
            {"depth", start["depth"]},
            {"weight", start["weight"]},
            {"what", event_name(here.happened())},
            {"data", to_json(here.happened())}};
}

nlohmann::json value_json(const Value& value) {
    if (const auto* condition = std::get_if<bool>(&value)) return *condition;
    if (const auto* number = std::get_if<double>(&value)) return number_json(*number);
    if (const auto* v = std::get_if<Vec3d>(&value))
        return {number_json(v->x), number_json(v->y), number_json(v->z)};
    if (const auto* text = std::get_if<std::string_view>(&value)) return *text;
    return nullptr;
}

} // namespace rayscope
