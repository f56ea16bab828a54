#include "exercises/grader/cut_case.hpp"

#include "core/scene/source_text.hpp"
#include "core/trace/trace_json.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rayscope::exercises {
namespace {

constexpr std::size_t most_bytes_of_record = std::size_t(256) << 20U;

Trace read_trace(const std::filesystem::path& path) {
    const std::string text = read_file(path, most_bytes_of_record);
    try {
        return trace_from_json(nlohmann::json::parse(text));
    } catch (const std::exception& error) {
        throw InputError(path.string(), {}, fmt::format("no trace: {}", error.what()));
    }
}

std::string code(const Vec3d& v) { return fmt::format("dvec3({}, {}, {})", v.x, v.y, v.z); }

/// The boundary on which the event happened: the last one before it.
const BoundaryChosen* boundary_before(const TracedRay& ray, std::size_t event) {
    const BoundaryChosen* last = nullptr;
    for (std::size_t i = 0; i < event; ++i)
        if (const auto* chosen = std::get_if<BoundaryChosen>(&ray.events[i])) last = chosen;
    return last;
}

} // namespace

CutCase cut_case(const std::filesystem::path& path, int event) {
    const Trace trace = read_trace(path);
    const auto fail = [&](const std::string& message) { throw InputError(path.string(), {}, message); };
    std::size_t total = 0;
    for (const TracedRay& ray : trace.rays) {
        const std::size_t first = total, wanted = std::size_t(std::max(event, 0));
        total += ray.events.size();
        if (wanted >= total) continue;
        const std::size_t index = wanted - first;
        const BoundaryChosen* const at = boundary_before(ray, index);
        const Event& what = ray.events[index];
        const std::string about = fmt::format("event {} of {}", event, path.filename().string());
        const Vec3d d = ray.start().direction;
        if (at != nullptr && std::holds_alternative<Reflected>(what))
            return {"3-01-mirror", fmt::format("c.add({}, {}, {}, {});", nlohmann::json(about).dump(),
                                               code(at->point), code(d), code(at->facing))};
        if (at != nullptr &&
            (std::holds_alternative<Refracted>(what) || std::holds_alternative<TotallyReflected>(what)))
            return {"4-02-refract",
                    fmt::format("c.add({}, {}, {}, double({}), double({}));", nlohmann::json(about).dump(),
                                code(d), code(at->facing), at->speed_from, at->speed_to)};
        fail(fmt::format(
            "event {} is none that an exercise asks for; expected reflected, refracted or totally_reflected",
            event));
    }
    fail(fmt::format("there is no event {}; expected 0 to {}", event,
                     total - std::min<std::size_t>(total, 1)));
    return {};
}

} // namespace rayscope::exercises
