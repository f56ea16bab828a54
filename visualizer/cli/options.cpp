#include "visualizer/cli/options.hpp"

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/failure.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace rayscope::cli {
namespace {

/// The options as texts: they are checked after all of them are known.
struct Texts {
    std::string scene, pixel, ray, digits, png, size, output, threads, statistics;
    bool no_png = false;
};

const char* const scene_help = "scene file (.toml, .nff), or the name of a scene that ships";

void add_ray_options(CLI::App& command, Texts& texts) {
    command.add_option("SCENE", texts.scene, std::string(scene_help) + "; without it the glass bowl")
        ->type_name("");
    command
        .add_option("--pixel", texts.pixel, "the pixel to trace; without it the scene's own, or its middle")
        ->type_name("X,Y");
    command.add_option("--ray", texts.ray, "a ray instead: origin and direction")
        ->type_name("ox,oy,oz,dx,dy,dz");
}

CLI::App& add_step(CLI::App& app, Texts& texts) {
    CLI::App& command = *app.add_subcommand("step", "walk through one ray's recursion, decision by decision");
    add_ray_options(command, texts);
    command.add_option("--digits", texts.digits, "significant digits of numbers, 1 to 17 (6)")
        ->type_name("N");
    command.add_option("--png", texts.png, "the picture's file (rayscope-step.png)")->type_name("FILE");
    command.add_flag("--no-png", texts.no_png, "text only");
    command.add_option("--size", texts.size, "size of the picture (1280x720)")->type_name("WxH");
    command.footer("On a terminal it then asks what to show next; `help` there lists the commands.\n\n"
                   "Example:\n  rayscope step glass_bowl --pixel 235,250 --digits 4\n");
    return command;
}

CLI::App& add_trace(CLI::App& app, Texts& texts) {
    CLI::App& command = *app.add_subcommand("trace", "write everything that one ray did to a file");
    add_ray_options(command, texts);
    command.add_option("-o", texts.output, "the file: .json, or .vtm for ParaView")->type_name("FILE");
    command.footer("Example:\n  rayscope trace glass_bowl --ray 0,0.2,5,0,0,-1 -o ray.json\n");
    return command;
}

CLI::App& add_render(CLI::App& app, Texts& texts) {
    CLI::App& command = *app.add_subcommand("render", "make the image of a scene");
    command.add_option("SCENE", texts.scene, scene_help)->type_name("");
    command.add_option("-o", texts.output, "the image: .png (sRGB), .pfm or .exr (linear, float)")
        ->type_name("FILE");
    command.add_option("--size", texts.size, "its size, instead of the scene's")->type_name("WxH");
    command.add_option("--threads", texts.threads, "how many work at it, instead of one for each processor")
        ->type_name("N");
    command.add_option("--stats", texts.statistics, "write times and counts to a JSON file")
        ->type_name("FILE");
    command.footer("Example:\n  rayscope render lens -o lens.png --size 1280x960\n");
    return command;
}

/// CLI11 collects what it does not know; the first of it is named, with the option that comes near.
void refuse_unknown(const CLI::App& command) {
    const auto unknown = command.remaining();
    if (unknown.empty()) return;
    if (!unknown.front().starts_with('-'))
        throw UsageError("unexpected argument " + in_quotes(unknown.front()));
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_positional()) names.push_back(option->get_name());
    const std::string given = unknown.front().substr(0, unknown.front().find('='));
    throw UsageError("unknown option " + in_quotes(given) +
                     did_you_mean(given, {names.begin(), names.end()}) + "; rayscope " + command.get_name() +
                     " --help lists the options");
}

RayChoice ray_choice(const Texts& texts) {
    RayChoice choice;
    choice.scene = texts.scene;
    if (!texts.pixel.empty() && !texts.ray.empty()) throw UsageError("--pixel and --ray exclude each other");
    if (!texts.pixel.empty()) choice.pixel = parse_pixel(texts.pixel);
    if (!texts.ray.empty()) choice.ray = parse_ray(texts.ray);
    return choice;
}

StepOptions step_options(const Texts& texts) {
    StepOptions options;
    options.choice = ray_choice(texts);
    if (!texts.digits.empty()) options.digits = parse_count("--digits", texts.digits, 1, 17);
    options.no_picture = texts.no_png;
    options.picture_asked_for = !texts.png.empty();
    if (texts.no_png && options.picture_asked_for) throw UsageError("--png and --no-png exclude each other");
    if (options.picture_asked_for) options.picture = texts.png;
    if (!texts.size.empty()) options.size = parse_size(texts.size);
    return options;
}

std::string needed_output(const Texts& texts, const char* command, const char* example) {
    if (texts.output.empty())
        throw UsageError(std::string(command) + " needs to know where to write: -o " + example);
    return texts.output;
}

RenderCommandOptions render_options(const Texts& texts) {
    RenderCommandOptions options;
    options.scene = texts.scene;
    if (texts.scene.empty()) throw UsageError("render needs a scene: rayscope render SCENE -o image.png");
    options.output = needed_output(texts, "render", "image.png");
    options.statistics = texts.statistics;
    if (!texts.size.empty()) options.size = parse_size(texts.size);
    if (!texts.threads.empty()) options.threads = parse_count("--threads", texts.threads, 1, 1024);
    return options;
}

} // namespace

Options parse_options(int count, const char* const* arguments) {
    Texts texts;
    CLI::App app("rayscope records everything that a ray does, and lets you walk through it.", "rayscope");
    app.require_subcommand(1);
    app.failure_message(CLI::FailureMessage::simple);
    app.footer("Example:\n  rayscope step\n");
    CLI::App& step = add_step(app, texts);
    CLI::App& trace = add_trace(app, texts);
    CLI::App& render = add_render(app, texts);
    for (CLI::App* command : {&step, &trace, &render}) command->allow_extras();

    const std::vector<std::string_view> names{"step", "trace", "render"};
    const std::string first = count > 1 ? arguments[1] : "";
    if (!first.empty() && !first.starts_with('-') &&
        std::find(names.begin(), names.end(), first) == names.end())
        throw UsageError("unknown command " + in_quotes(first) + did_you_mean(first, names) + "; expected " +
                         one_of(names));
    try {
        app.parse(count, arguments);
    } catch (const CLI::CallForHelp&) {
        return Help{app.help()};
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + "; rayscope --help tells more");
    }
    refuse_unknown(*app.get_subcommands().front());
    if (step.parsed()) return step_options(texts);
    if (render.parsed()) return render_options(texts);
    return TraceOptions{ray_choice(texts), needed_output(texts, "trace", "ray.json")};
}

} // namespace rayscope::cli
