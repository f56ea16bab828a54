#include "visualizer/cli/second_run.hpp"

#include "visualizer/cli/compare_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/scene_choice.hpp"

namespace rayscope::cli {
namespace {

constexpr std::size_t most_rows = 24; // a person reads no more

Ray<double> given_ray(const Trace& trace) {
    const RaySpawned& start = trace.rays.front().start();
    return {start.origin, start.direction};
}

bool is_scene(const std::string& text) {
    for (const char* extension : {".toml", ".nff", ".obj", ".ply"})
        if (text.ends_with(extension)) return true;
    return false;
}

std::string cut_to(const std::string& text, std::size_t width) {
    std::string cut;
    std::size_t used = 0;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = std::max<std::size_t>(1, utf8_length(std::string_view(text).substr(at)));
        std::string character = text.substr(at, length);
        if (character == glue) character = " ";
        at += length;
        if (used + 1 == width && at < text.size()) {
            cut += "…";
            ++used;
            break;
        }
        cut += character;
        ++used;
    }
    return cut + std::string(width - used, ' ');
}

/// A row for each ray that both runs have, up to the one where they part.
std::string side_by_side(const Trace& a, const Trace& b, const Comparison& comparison,
                         const StepStyle& style) {
    constexpr std::size_t label = 14, side = 32;
    const int last =
        comparison.divergence ? comparison.divergence->ray : int(std::min(a.rays.size(), b.rays.size())) - 1;
    const int first = std::max(0, last - int(most_rows) + 1);
    std::string text =
        cut_to("", label) + style.paint.bold(cut_to("A", side)) + " " + style.paint.bold("B") + "\n";
    if (first > 0) text += "… " + std::to_string(first) + " rays on which they agree\n";
    const Numbers number(5);
    for (int ray = first; ray <= last && std::size_t(ray) < b.rays.size(); ++ray) {
        const bool parts = comparison.divergence && ray == last;
        const RayKind kind = a.rays[std::size_t(ray)].start().kind;
        text += style.paint.kind(kind, cut_to(std::to_string(ray) + " " + name_of(kind), label)) +
                cut_to(ray_summary(a, ray, number), side) + (parts ? "≠" : " ") +
                cut_to(ray_summary(b, ray, number), side) + "\n";
    }
    return text;
}

} // namespace

SecondRun run_by_stage(const std::string& command, const std::string& stage, const Workbench& bench,
                       const Trace& trace) {
    try {
        const StageChoice choice = stage_choice(stage);
        const auto stages = make_stages(bench, choice);
        return {"double stable, found by " + described(choice),
                trace.source.by_hand ? trace_ray(bench, *stages, given_ray(trace))
                                     : trace_pixel(bench, *stages, trace.source.x, trace.source.y)};
    } catch (const std::invalid_argument& error) {
        throw UsageError(command + ": " + error.what());
    }
}

SecondRun run_of_scene(const std::string& scene, const Trace& trace) {
    RayChoice choice;
    choice.scene = scene;
    if (trace.source.by_hand)
        choice.ray = given_ray(trace);
    else
        choice.pixel = {trace.source.x, trace.source.y};
    const Workbench other = open(find_scene(scene));
    return {harmless(other.scene.file), trace_choice(other, choice)};
}

SecondRun second_run(const std::string& command, const std::string& what, const Workbench& bench,
                     const Trace& trace) {
    if (what.empty())
        throw UsageError(command +
                         ": expected numbers or limits, such as float,textbook, or stage NAME, or a scene");
    if (what.starts_with("stage ")) return run_by_stage(command, what.substr(6), bench, trace);
    if (is_scene(what)) return run_of_scene(what, trace);
    const Configuration other = chosen_configuration(command, what, own_configuration(bench.scene));
    return {name_of(other), traced_again(bench, trace, other), other.numbers.scalar};
}

Comparison compared(const SecondRun& second, const Workbench& bench, const Trace& trace) {
    return rayscope::compare(trace, second.trace, precision_of(own_configuration(bench.scene).numbers.scalar),
                             precision_of(second.scalar));
}

std::string second_run_text(const SecondRun& second, const Workbench& bench, const Trace& trace,
                            const StepStyle& style) {
    return side_by_side(trace, second.trace, compared(second, bench, trace), style) + "\n" +
           compare_text(
               {name_of(own_configuration(bench.scene)) + ": the scene's own", trace, ScalarType::float64},
               {second.name, second.trace, second.scalar}, style);
}

} // namespace rayscope::cli
