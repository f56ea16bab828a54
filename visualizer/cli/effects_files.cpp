#include "visualizer/cli/effects_files.hpp"

#include "visualizer/cli/page.hpp"
#include "visualizer/cli/paint.hpp"
#include "visualizer/cli/picture_process.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>

namespace rayscope::cli {
namespace fs = std::filesystem;
namespace {

std::string_view effect_name(const EffectCost& cost) { return effect_names[std::size_t(cost.effect)].name; }

nlohmann::ordered_json json_of(const std::string& scene, const EffectCosts& costs) {
    nlohmann::ordered_json json{{"format", "rayscope-effects"}, {"version", 1}, {"scene", scene}};
    for (const EffectCost& cost : costs.effects) {
        nlohmann::ordered_json one{{"effect", effect_name(cost)}, {"called_for", cost.taken_away}};
        one["time_ratio"] = {
            {"median", cost.time_ratio}, {"least", cost.least_ratio}, {"greatest", cost.greatest_ratio}};
        one["difference"] = cost.difference;
        one["similarity"] = std::isfinite(cost.similarity) ? nlohmann::ordered_json(cost.similarity)
                                                           : nlohmann::ordered_json(nullptr);
        one["light"] = {cost.light.x, cost.light.y, cost.light.z};
        for (const RayKind kind : {RayKind::eye, RayKind::reflected, RayKind::refracted, RayKind::shadow})
            one["rays"][name_of(kind)] = cost.rays[std::size_t(kind)];
        json["effects"].push_back(std::move(one));
    }
    return json;
}

void tell(const fs::path& path) { std::puts(harmless(path.string()).c_str()); }

} // namespace

void write_effects(const std::string& scene, const EffectCosts& costs, const fs::path& folder) {
    for (const EffectCost& cost : costs.effects) {
        const fs::path path = folder / (std::string(effect_name(cost)) + ".png");
        write_image(strip(costs, cost), path);
        tell(path);
    }
    const fs::path numbers = folder / "effects.json";
    write_text_file(numbers, json_of(scene, costs).dump(2) + "\n");
    tell(numbers);
    if (!can_draw()) {
        std::fprintf(stderr, "rayscope: no chart: %s\n", how_to_draw());
        return;
    }
    draw_effects(numbers);
    tell(folder / "effects.png");
}

} // namespace rayscope::cli
