#include "core/stage/stage_choice.hpp"

#include <fmt/format.h>

#include <stdexcept>

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

void set(StageChoice& choice, std::string_view ray, std::string_view name) {
    if (ray == "eye")
        choice.eye = kind_for(ray, name, StageKind::projective);
    else if (ray == "shadow")
        choice.shadow = kind_for(ray, name, StageKind::light);
    else if (ray == "other")
        choice.other = kind_for(ray, name, std::nullopt);
    else
        throw std::invalid_argument(fmt::format("expected eye=, shadow= or other=, found '{}='", ray));
}

} // namespace

std::string_view name_of(StageKind kind) { return names[std::size_t(kind)]; }

StageChoice stage_choice(std::string_view text) {
    for (const Rung& rung : rungs)
        if (text == rung.name) return rung.choice;
    if (text.find('=') == std::string_view::npos)
        throw std::invalid_argument(
            fmt::format("expected best, scan, extents, projective, light, octree, bvh, or "
                        "eye=…,shadow=…,other=…, found '{}'",
                        text));
    StageChoice choice = rungs.back().choice;
    while (true) {
        const auto comma = text.find(',');
        const std::string_view word = text.substr(0, comma);
        const auto equals = word.find('=');
        if (equals == std::string_view::npos)
            throw std::invalid_argument(fmt::format("expected eye=, shadow= or other=, found '{}'", word));
        set(choice, word.substr(0, equals), word.substr(equals + 1));
        if (comma == std::string_view::npos) return choice;
        text.remove_prefix(comma + 1);
    }
}

std::string described(const StageChoice& choice) {
    if (choice.eye == choice.shadow && choice.shadow == choice.other) return std::string(name_of(choice.eye));
    return fmt::format("{} for eye rays, {} for shadow rays, {} for all others", name_of(choice.eye),
                       name_of(choice.shadow), name_of(choice.other));
}

} // namespace rayscope
