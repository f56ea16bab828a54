#include "exercises/grader/cut_case.hpp"

#include "core/scene/source_text.hpp"
#include "core/walk/fields.hpp"
#include "exercises/grader/event_case.hpp"
#include "exercises/grader/trace_text.hpp"

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

} // namespace

CutCase cut_case(const Trace& trace, int event) {
    const auto fail = [](const std::string& message) { throw InputError("--event", {}, message); };
    std::size_t total = 0;
    for (const TracedRay& ray : trace.rays) {
        const std::size_t first = total;
        total += ray.events.size();
        if (event < 0 || std::size_t(event) >= total) continue;
        const EventPlace place{trace, ray, std::size_t(event) - first};
        for (const auto find : {surface_case, inside_case, search_case, path_case})
            if (const auto found = find(place); found && found->arguments.find("nan") == std::string::npos)
                return {found->exercise,
                        fmt::format("c.add(\"event {} of a recorded trace\", {});", event, found->arguments)};
        fail(fmt::format(
            "event {} is '{}' of a ray of kind '{}', which no exercise's function answers; expected, "
            "for example, reflected, refracted, boundary_chosen, node_evaluated or place_entered",
            event, event_name(ray.events[place.index]), name_of(ray.start().kind)));
    }
    fail(fmt::format("there is no event {}; expected 0 to {}", event,
                     total - std::min<std::size_t>(total, 1)));
    return {};
}

CutCase cut_case(const std::filesystem::path& path, int event) { return cut_case(read_trace(path), event); }

} // namespace rayscope::exercises
