#include "core/stage/stage_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <stdexcept>
#include <vector>

namespace rayscope {
namespace {

constexpr std::array<std::string_view, 6> names{"scan", "extents", "projective", "light", "octree", "bvh"};

// What serves any ray.
constexpr std::array<StageKind, 4> general{StageKind::scan, StageKind::extents, StageKind::octree,
                                           StageKind::bvh};

StageKind kind_for(std::string_view ray, std::string_view name, std::optional<StageKind> special) {
    std::string expected;
    for (const StageKind kind : general) {
        if (name == name_of(kind)) return kind;
        expected += std::string(expected.empty() ? "" : ", ") + std::string(name_of(kind));
    }
    if (special && name == name_of(*special)) return *special;
    if (special) expected += ", " + std::string(name_of(*special));
    throw std::invalid_argument(fmt::format("expected {} after '{}=', found '{}'", expected, ray, name));
}

template <typename Number>
Number limit_of(std::string_view name, std::string_view text, Number least, Number most,
                const char* expected) {
    Number number{};
    const auto [end, error] = std::from_chars(text.begin(), text.end(), number);
    if (error != std::errc{} || end != text.end() || !(number >= least && number <= most))
        throw std::invalid_argument(fmt::format("expected {} after '{}=', found '{}'", expected, name, text));
    return number;
}

constexpr std::array<std::string_view, 6> settings{"eye",      "shadow", "other",
                                                   "capacity", "depth",  "least_size"};

bool is_limit(std::string_view setting) {
    return std::find(settings.begin() + 3, settings.end(), setting) != settings.end();
}

void set(StageChoice& choice, std::string_view setting, std::string_view value) {
    if (setting == "eye")
        choice.eye = kind_for(setting, value, StageKind::projective);
    else if (setting == "shadow")
        choice.shadow = kind_for(setting, value, StageKind::light);
    else if (setting == "other")
        choice.other = kind_for(setting, value, std::nullopt);
    else if (setting == "capacity")
        choice.octree.capacity =
            limit_of(setting, value, 1, 1000000, "a number of objects from 1 to 1000000");
    else if (setting == "depth")
        choice.octree.depth =
            limit_of(setting, value, 1, OctreeLimits::deepest,
                     fmt::format("a number of levels from 1 to {}", OctreeLimits::deepest).c_str());
    else if (setting == "least_size")
        choice.octree.least_size = limit_of(setting, value, std::numeric_limits<double>::min(), 1.0,
                                            "a share of the whole's edge, above 0 and up to 1");
    else
        throw std::invalid_argument(fmt::format(
            "expected eye=, shadow=, other= or, of an octree, capacity=, depth= or least_size=, found '{}'",
            setting));
}

} // namespace

std::string_view name_of(StageKind kind) { return names[std::size_t(kind)]; }

StageChoice stage_choice(std::string_view text) {
    const std::string_view first = text.substr(0, text.find(','));
    const auto rung = std::ranges::find(rungs, first, &Rung::name);
    const bool is_rung = rung != rungs.end();
    if (!is_rung && first.find('=') == std::string_view::npos)
        throw std::invalid_argument(
            fmt::format("expected best, scan, extents, projective, light, octree, bvh, or "
                        "eye=…,shadow=…,other=…, found '{}'",
                        text));
    StageChoice choice = is_rung ? rung->choice : rungs.back().choice;
    std::vector<std::string_view> seen;
    for (std::string_view rest = is_rung ? text.substr(first.size()) : text; !rest.empty();) {
        if (rest.starts_with(',')) rest.remove_prefix(1);
        const std::string_view word = rest.substr(0, rest.find(','));
        rest.remove_prefix(word.size());
        const auto equals = word.find('=');
        const std::string_view setting = word.substr(0, equals);
        if (is_rung && !is_limit(setting))
            throw std::invalid_argument(
                fmt::format("expected capacity=, depth= or least_size= after '{}', found '{}'", first, word));
        if (equals == std::string_view::npos && std::ranges::find(settings, setting) != settings.end())
            throw std::invalid_argument(fmt::format("expected a value after '{}='", word));
        if (std::ranges::find(seen, setting) != seen.end())
            throw std::invalid_argument(fmt::format("'{}=' stands there twice", setting));
        seen.push_back(setting);
        set(choice, setting, equals == std::string_view::npos ? "" : word.substr(equals + 1));
    }
    const bool has_octree = choice.eye == StageKind::octree || choice.shadow == StageKind::octree ||
                            choice.other == StageKind::octree;
    if (!has_octree && choice.octree != OctreeLimits{})
        throw std::invalid_argument(fmt::format("'{}' limits an octree, but no rays are found by one", text));
    return choice;
}

std::string described(const StageChoice& choice) {
    if (choice.eye == choice.shadow && choice.shadow == choice.other) return std::string(name_of(choice.eye));
    return fmt::format("{} for eye rays, {} for shadow rays, {} for all others", name_of(choice.eye),
                       name_of(choice.shadow), name_of(choice.other));
}

} // namespace rayscope
