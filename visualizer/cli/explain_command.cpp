// rayscope explain: which effects a scene calls for, and what they cost.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/effects_files.hpp"
#include "visualizer/cli/explain_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/interrupts.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/progress.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/warnings.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <unistd.h>

namespace rayscope::cli {
namespace {

// An image of the scene's shape, small enough to be made many times.
Size usual_size(const Camera& camera) {
    constexpr int longer_side = 192;
    const int longest = std::max(camera.width, camera.height);
    if (longest <= longer_side) return {camera.width, camera.height};
    const auto scaled = [&](int side) { return std::max(1, side * longer_side / longest); };
    return {scaled(camera.width), scaled(camera.height)};
}

RenderOptions render_options(const Size& size, int threads) {
    RenderOptions options;
    options.width = size.width;
    options.height = size.height;
    options.threads = threads;
    options.stop = &stop_asked_for;
    return options;
}

// The mean light of a pixel that each effect which the scene calls for, but which is off, would bring by itself.
std::vector<std::pair<Effect, Colour>> light_off(const Workbench& bench, const std::filesystem::path& path,
                                                 const Size& size) {
    const auto needs = [](const Workbench& b) { return needed_effects(effect_needs(b.scene, b.world)); };
    const Workbench whole = make_workbench(load_scene(path, "auto"));
    const EffectSet called_for = needs(whole), on = needs(bench);
    std::vector<std::pair<Effect, Colour>> off;
    const auto light = [&](const Workbench& b) {
        return ledger(b, size.width, size.height, &stop_asked_for).total;
    };
    std::optional<Colour> with_all;
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        const auto effect = Effect(i);
        if (!called_for.has(effect) || on.has(effect)) continue;
        Scene without = whole.scene;
        take_away(effect, without);
        if (!with_all) with_all = light(whole);
        off.emplace_back(effect, *with_all - light(make_workbench(without)));
    }
    return off;
}

} // namespace

int explain(const ExplainOptions& options) {
    const std::filesystem::path path = find_scene(options.scene);
    const Workbench bench = make_workbench(load_with_effects(path, options.effects));
    if (options.output) prepare_folder(*options.output, "effects.json");
    print_warnings(bench.scene);
    const Paint paint(wants_colours(STDOUT_FILENO));
    Page page(paint);
    page.rule(paint.bold(harmless(bench.scene.file)));
    add_effects(page, bench);

    catch_interrupts();
    const Size size = options.size.value_or(usual_size(bench.scene.camera));
    const RenderOptions tracing = render_options(size, options.threads);
    const RenderResult result = render(bench, tracing);
    if (!result.complete) return stopped();
    add_rays(page, result);
    if (options.energy) {
        const auto name = [&](Id object) {
            return object_title(bench.scene, bench.scene.drawn[std::size_t(object)]);
        };
        add_ledger(page, ledger(bench, size.width, size.height, &stop_asked_for), "each pixel, in the mean",
                   name, Numbers(3));
        add_light_off(page, light_off(bench, path, size), Numbers(3));
        if (stop_asked_for) return stopped();
    }
    if (options.cost) {
        EffectCostOptions measuring;
        measuring.render = tracing;
        measuring.rounds = options.rounds;
        EffectCosts costs;
        {
            Progress progress("effects");
            measuring.render.progress = [&](double share) { progress.show(share); };
            costs =
                effect_costs(bench.scene, needed_effects(effect_needs(bench.scene, bench.world)), measuring);
        }
        if (!costs.complete) return stopped();
        add_costs(page, costs);
        if (options.output) write_effects(bench.scene.file, costs, *options.output);
    }
    std::fputs(page.text().c_str(), stdout);
    return done;
}

} // namespace rayscope::cli
