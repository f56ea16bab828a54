// rayscope render: a scene's image.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/compare_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/interrupts.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/cli/progress.hpp"
#include "visualizer/cli/render_report.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/warnings.hpp"

#include <cstdio>

namespace rayscope::cli {
namespace {

void check_arguments(const RenderCommandOptions& options) {
    if (options.heat) {
        check_output("-o", options.output, {".png", ".pfm"});
        if (std::filesystem::path(options.output).extension() == ".png" && !can_draw())
            throw std::runtime_error(std::string(how_to_draw()) + "; the numbers as they are: -o heat.pfm");
    } else {
        check_output("-o", options.output, {".png", ".pfm", ".exr"});
    }
    if (options.statistics) check_output("--stats", *options.statistics, {".json"});
}

void write(const RenderResult& result, const RenderCommandOptions& options) {
    if (!options.heat) {
        write_image(result.image, options.output);
    } else if (std::filesystem::path(options.output).extension() == ".pfm") {
        write_map(result.heat, options.output);
    } else {
        draw_heat(result.heat, std::string(heat_names[std::size_t(*options.heat)].meaning), options.output);
    }
}

} // namespace

int render(const RenderCommandOptions& options) {
    check_arguments(options);
    if (options.configuration) (void)chosen_configuration("--config", *options.configuration, {});
    RenderReport report;
    const std::filesystem::path path = find_scene(options.scene);
    report.scene = path.string();
    report.output = options.output;

    const Stopwatch loading;
    const Scene scene = load_with_effects(path, options.effects);
    report.load = loading.elapsed();
    print_warnings(scene);
    const Stopwatch building;
    const Configuration own = own_configuration(scene);
    const Configuration chosen =
        options.configuration ? chosen_configuration("--config", *options.configuration, own) : own;
    if (options.stage && *options.stage != StageChoice{} && chosen.numbers != NumbersChoice{})
        throw UsageError("--stage: other numbers than double stable scan; expected scan with this --config");
    const auto trace = renderer(scene, chosen);
    report.build = building.elapsed();

    RenderOptions tracing;
    if (options.size) {
        tracing.width = options.size->width;
        tracing.height = options.size->height;
    }
    tracing.threads = options.threads;
    tracing.stage = options.stage;
    tracing.heat = options.heat;
    tracing.samples = options.samples;
    tracing.even_samples = options.even_samples;
    if (options.even_samples && (options.samples > 0 ? options.samples : scene.camera.samples) == 1)
        throw UsageError(
            "--even-samples: each pixel has one sample; expected --samples N beside it, more than 1");
    tracing.stop = &stop_asked_for;
    catch_interrupts();
    RenderResult result;
    {
        Progress progress("image");
        tracing.progress = [&](double share) { progress.show(share); };
        result = trace(tracing);
    }
    if (!result.complete || stop_asked_for) return stopped();
    report.trace = {result.statistics.cpu_seconds, result.statistics.wall_seconds};
    report.counters = result.statistics.counters;
    report.stage = described(result.statistics.stage);
    report.stage_reason = result.statistics.stage_reason;
    report.stage_build = result.statistics.build_seconds;
    report.octree = result.statistics.octree;
    report.width = result.image.width;
    report.height = result.image.height;
    report.image_hash = hash(result.image);

    const Stopwatch writing;
    write(result, options);
    report.write = writing.elapsed();
    std::error_code error;
    const auto bytes = std::filesystem::file_size(options.output, error);
    report.file_bytes = error ? 0 : bytes;
    if (options.statistics) write_text_file(*options.statistics, report_json(report));
    std::fputs(report_text(report).c_str(), stdout);
    return done;
}

} // namespace rayscope::cli
