// rayscope find: pixels whose traces have an event.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/find_text.hpp"
#include "visualizer/cli/interrupts.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/progress.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/warnings.hpp"

#include <cstdio>
#include <nlohmann/json.hpp>

#include <unistd.h>

namespace rayscope::cli {
namespace {

void write_mask(const FindResult& result, const std::string& output) {
    if (std::filesystem::path(output).extension() == ".pfm") {
        write_map(result.events, output);
        return;
    }
    Image mask(result.events.width, result.events.height);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) mask.set(x, y, Colour{result.events.at(x, y) > 0 ? 1.0 : 0.0});
    write_image(mask, output);
}

std::string as_json(const Workbench& bench, const FindCommandOptions& options, const FindOptions& finding,
                    const Expression& condition, const FindResult& result) {
    nlohmann::json list = nlohmann::json::array();
    const auto pixels = found_pixels(result, std::size_t(options.listed));
    for (const FoundPixel& pixel : pixels)
        list.push_back({{"x", pixel.x}, {"y", pixel.y}, {"events", pixel.events}});
    nlohmann::json json = {{"scene", bench.scene.file},
                           {"where", options.where},
                           {"width", result.events.width},
                           {"height", result.events.height},
                           {"pixels", result.pixels},
                           {"record_full", result.cut},
                           {"list", list},
                           {"first", nullptr}};
    if (const auto first = found_pixels(result, 1); !first.empty()) {
        const Trace trace = trace_found(bench, finding, first[0].x, first[0].y);
        if (const auto at = first_occurrence(trace, condition))
            json["first"] = {{"x", first[0].x}, {"y", first[0].y}, {"ray", at->ray}, {"event", at->event}};
    }
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace

int find(const FindCommandOptions& options) {
    if (options.output) check_output("-o", *options.output, {".png", ".pfm"});
    const Workbench bench = open(find_scene(options.scene));
    print_warnings(bench.scene);
    const Expression condition = expression_of("--where", options.where, vocabulary_of(bench.scene));
    need_condition("--where", condition);
    need_stage("--where", condition, options.by_stage);
    FindOptions finding;
    finding.by_stage = options.by_stage;
    finding.render.stage = options.stage;
    finding.render.threads = options.threads;
    finding.render.width = options.size ? options.size->width : bench.scene.camera.width;
    finding.render.height = options.size ? options.size->height : bench.scene.camera.height;
    finding.render.stop = &stop_asked_for;
    catch_interrupts();
    FindResult result;
    {
        Progress progress("looking");
        finding.render.progress = [&](double share) { progress.show(share); };
        result = rayscope::find(bench.scene, bench.world, condition, finding);
    }
    if (!result.complete || stop_asked_for) return stopped();
    if (options.output) write_mask(result, *options.output);
    if (options.json) {
        std::printf("%s\n", as_json(bench, options, finding, condition, result).c_str());
        return done;
    }
    const StepStyle style{Numbers(6), Paint(wants_colours(STDOUT_FILENO))};
    std::fputs(find_text(bench, condition, result, finding, std::size_t(options.listed), style).c_str(),
               stdout);
    if (const auto first = found_pixels(result, 1); !first.empty() && !options.size)
        std::printf("  walk there   rayscope step %s --pixel %d,%d\n", harmless(options.scene).c_str(),
                    first[0].x, first[0].y);
    if (options.output) std::printf("  mask         %s\n", harmless(*options.output).c_str());
    return done;
}

} // namespace rayscope::cli
