#include "visualizer/cli/explain_text.hpp"

#include "visualizer/cli/ray_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayscope::cli {
namespace {

std::string reason_text(const EffectNeed& need) {
    return need.reason + " (" + std::string(effect_names[std::size_t(need.effect)].meaning) + ")";
}

std::string rays_text(std::int64_t count) { return fmt::format("{}{}", count > 0 ? "+" : "", count); }

std::string limit_text(Reason reason) {
    switch (reason) {
    case Reason::depth: return "deeper than max_depth";
    case Reason::weight: return "below min_weight";
    case Reason::ray_limit: return "beyond max_rays";
    default: return "without a coefficient";
    }
}

} // namespace

void add_effects(Page& page, const Workbench& bench) {
    const auto needs = effect_needs(bench.scene, bench.world);
    const auto list = [&](const char* heading, const auto& holds) {
        if (std::ranges::none_of(needs, holds)) return;
        page.heading(heading);
        for (const EffectNeed& need : needs)
            if (holds(need))
                page.item(std::string(effect_names[std::size_t(need.effect)].name),
                          need.needed ? reason_text(need) : need.reason);
    };
    const auto is_added = [&](const EffectNeed& n) { return n.needed && bench.scene.added.has(n.effect); };
    list("Simulated, since the scene calls for it",
         [&](const EffectNeed& n) { return n.needed && !is_added(n); });
    list("Simulated, as it was asked", is_added);
    list("Not simulated", [](const EffectNeed& n) { return !n.needed; });
    page.heading("How");
    const EffectSet needed = needed_effects(needs);
    const bool refracted = needed.has(Effect::refraction);
    std::string kinds = "eye", none_of;
    for (const auto& [kind, spawned] :
         {std::pair{RayKind::reflected, refracted || needed.has(Effect::reflection)},
          {RayKind::refracted, refracted},
          {RayKind::shadow, needed.has(Effect::shadows)}})
        (spawned ? kinds : none_of)
            .append(std::string(spawned || !none_of.empty() ? ", " : "") + name_of(kind));
    page.item("rays", kinds + (none_of.empty() ? "" : "; no " + none_of + " ones"));
    page.item("tracer", bench.world.effects == EffectMask::classic && bench.scene.camera.samples == 1
                            ? "the classic one: nothing is asked about the added effects"
                            : "the one with all effects");
    const Limits& limits = bench.scene.limits;
    page.item("limits", fmt::format("max_depth {}, min_weight {:.6g}, max_rays {} for each sample",
                                    limits.max_depth, limits.min_weight, limits.max_rays));
    if (needed.has(Effect::dispersion))
        page.item("spectrum",
                  fmt::format("{} {} behind the first boundary that spreads colours", limits.wavelengths,
                              limits.wavelengths == 1 ? "wavelength" : "wavelengths"));
}

void add_rays(Page& page, const RenderResult& result) {
    const RenderStatistics& statistics = result.statistics;
    page.heading(fmt::format("Rays of an image of {} × {} pixels", result.image.width, result.image.height));
    page.item("stage", described(statistics.stage) + (statistics.stage_reason.empty() ? "" : ": ") +
                           statistics.stage_reason);
    const double pixels = double(result.image.width) * result.image.height;
    for (const RayKind kind : {RayKind::eye, RayKind::reflected, RayKind::refracted, RayKind::shadow}) {
        const auto count = statistics.counters.rays[std::size_t(kind)];
        page.item(name_of(kind), fmt::format("{}, {:.3g} for each pixel", count, double(count) / pixels));
    }
    const Counters& counters = statistics.counters;
    page.item("not followed",
              fmt::format("{} deeper than max_depth, {} below min_weight, {} beyond max_rays",
                          counters.cut_by_depth, counters.cut_by_weight, counters.cut_by_ray_limit));
    if (counters.total_reflections > 0)
        page.item("total", fmt::format("{} total reflections", counters.total_reflections));
}

void add_costs(Page& page, const EffectCosts& costs) {
    page.heading("What each effect costs and changes");
    page.line(
        "Time: of the image with it to that without (median; least to greatest of the rounds). ΔE: mean "
        "CIEDE2000 between the two; about 1 is just visible side by side. Rays: more with it.",
        2);
    page.gap();
    page.line(fmt::format("  {:<14}{:<12}{:>6}  {:<14}{:>7}{:>8}{:>12}", "effect", "", "time", "", "ΔE",
                          "SSIM", "rays"));
    for (const EffectCost& cost : costs.effects) {
        std::int64_t rays = 0;
        for (const std::int64_t of_kind : cost.rays) rays += of_kind;
        page.line(fmt::format(
            "  {:<14}{:<12}{:>6.2f}  {:<14}{:>6.2f}{:>8}{:>12}", effect_names[std::size_t(cost.effect)].name,
            cost.taken_away ? "taken away" : "added", cost.time_ratio,
            fmt::format("{:.2f} to {:.2f}", cost.least_ratio, cost.greatest_ratio), cost.difference,
            std::isfinite(cost.similarity) ? fmt::format("{:.3f}", cost.similarity) : "–", rays_text(rays)));
    }
    if (costs.nowhere.empty()) return;
    std::string names;
    for (const Effect effect : costs.nowhere)
        names.append(names.empty() ? "" : ", ").append(effect_names[std::size_t(effect)].name);
    page.gap();
    page.line("Nothing in the scene to add it to: " + names, 2);
}

void add_ledger(Page& page, const Ledger& ledger, const std::string& weighed,
                const std::function<std::string(Id)>& name, const Numbers& number) {
    page.heading("Where the light comes from");
    std::vector<std::pair<LightSource, Colour>> sources(ledger.sources.begin(), ledger.sources.end());
    std::ranges::sort(sources, [](const auto& a, const auto& b) {
        const double first = largest_component(a.second), second = largest_component(b.second);
        return first != second ? first > second : a.first < b.first;
    });
    const double whole = ledger.total.x + ledger.total.y + ledger.total.z;
    for (const auto& [source, light] : sources) {
        const double part = light.x + light.y + light.z;
        std::string text = number.colour(light);
        if (whole > 0) text += fmt::format(", {:.1f} %", 100 * part / whole);
        text += ": " + std::string(light_kind_names[std::size_t(source.kind)]);
        if (source.object != none) text += " of '" + name(source.object) + "'";
        page.item(name_of(source.brought_by), text + ", by " + name_of(source.brought_by) + " rays");
    }
    page.item("in all", number.colour(ledger.total));
    if (largest_component(ledger.absorbed) > 0)
        page.item("absorbed", number.colour(ledger.absorbed) + ", swallowed by media on the way");
    page.heading("What was dropped");
    bool any = false;
    for (const auto& [key, dropped] : ledger.dropped) {
        if (key.second == Reason::coefficient_zero) continue;
        any = true;
        page.item(name_of(key.first), fmt::format("{} {} {}, with a weight of {} of {}", dropped.count,
                                                  dropped.count == 1 ? "ray" : "rays", limit_text(key.second),
                                                  number.colour(dropped.weight), weighed));
    }
    if (!any) page.line("nothing: every ray with a weight was followed", 2);
}

void add_light_off(Page& page, const std::vector<std::pair<Effect, Colour>>& off, const Numbers& number) {
    if (off.empty()) return;
    page.heading("Off, though the scene calls for it");
    for (const auto& [effect, light] : off) {
        const bool less = light.x + light.y + light.z < 0;
        page.item(std::string(effect_names[std::size_t(effect)].name),
                  (less ? "takes " : "brings ") + number.colour(less ? -light : light) + " by itself");
    }
}

} // namespace rayscope::cli
