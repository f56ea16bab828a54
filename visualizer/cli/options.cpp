#include "visualizer/cli/options.hpp"

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/failure.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>

namespace rayscope::cli {
namespace {

/// The options as texts: they are checked after all of them are known. An empty one was given, and is wrong.
struct Texts {
    using Text = std::optional<std::string>;
    Text scene, pixel, ray, digits, png, size, output, threads, statistics, why, compare;
    Text configurations, target_error, runs, reference_rays;
    bool no_png = false, cases = false;
};

const char* const scene_help = "scene file (.toml, .nff), or the name of a scene that ships";

void add_text(CLI::App& command, const char* name, Texts::Text& text, const char* value,
              const std::string& help) {
    command.add_option_function<std::string>(
               name, [&text](const std::string& given) { text = given; }, help)
        ->type_name(value)
        ->take_last(); // a second one is refused below, in words of this program
}

void add_ray_options(CLI::App& command, Texts& texts) {
    add_text(command, "SCENE", texts.scene, "", std::string(scene_help) + "; without it the glass bowl");
    add_text(command, "--pixel", texts.pixel, "X,Y",
             "the pixel to trace; without it the scene's own, or its middle");
    add_text(command, "--ray", texts.ray, "ox,oy,oz,dx,dy,dz", "a ray instead: origin and direction");
}

CLI::App_p make_step(Texts& texts) {
    auto made = std::make_shared<CLI::App>("walk through one ray's recursion, decision by decision", "step");
    CLI::App& command = *made;
    add_ray_options(command, texts);
    add_text(command, "--digits", texts.digits, "N", "significant digits of numbers, 1 to 17 (6)");
    add_text(command, "--png", texts.png, "FILE", "the picture's file (rayscope-step.png)");
    command.add_flag("--no-png", texts.no_png, "text only");
    add_text(command, "--size", texts.size, "WxH", "size of the picture (1280x720)");
    add_text(command, "--why", texts.why, "NAME",
             "only why each ray did not end on this drawn object; no picture without --png");
    add_text(
        command, "--compare", texts.compare, "LIST",
        "only where the same ray with other numbers or limits, such as float,textbook, first goes another "
        "way; no picture");
    command.footer("On a terminal it then asks what to show next; `help` there lists the commands.\n\n"
                   "Example:\n  rayscope step glass_bowl --pixel 235,250 --digits 4\n"
                   "  rayscope step far_tiny_sphere --compare float,textbook\n");
    return made;
}

CLI::App_p make_trace(Texts& texts) {
    auto made = std::make_shared<CLI::App>("write everything that one ray did to a file", "trace");
    CLI::App& command = *made;
    add_ray_options(command, texts);
    add_text(command, "-o", texts.output, "FILE", "the file: .json, or .vtm for ParaView");
    command.footer("Example:\n  rayscope trace glass_bowl --ray 0,0.2,5,0,0,-1 -o ray.json\n");
    return made;
}

CLI::App_p make_render(Texts& texts) {
    auto made = std::make_shared<CLI::App>("make the image of a scene", "render");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    add_text(command, "-o", texts.output, "FILE", "the image: .png (sRGB), .pfm or .exr (linear, float)");
    add_text(command, "--size", texts.size, "WxH", "its size, instead of the scene's");
    add_text(command, "--threads", texts.threads, "N",
             "how many work at it, instead of one for each processor");
    add_text(command, "--config", texts.configurations, "LIST",
             "other numbers or limits than the scene's, such as float,textbook,depth=3");
    add_text(command, "--stats", texts.statistics, "FILE", "write times and counts to a JSON file");
    command.footer("Example:\n  rayscope render lens -o lens.png --size 1280x960\n");
    return made;
}

CLI::App_p make_accuracy(Texts& texts) {
    auto made = std::make_shared<CLI::App>("tell what accuracy costs: time against error", "accuracy");
    CLI::App& command = *made;
    add_text(command, "SCENE", texts.scene, "", scene_help);
    command.add_flag(
        "--cases", texts.cases,
        "instead of a scene: what each number type gets wrong on the oracle's hard cases, or on those "
        "of the folder that stands in place of SCENE");
    add_text(command, "-o", texts.output, "FOLDER", "also write table, chart and error maps to this folder");
    add_text(command, "--size", texts.size, "WxH",
             "size of the images (the scene's, its longer side made 96)");
    add_text(
        command, "--configs", texts.configurations, "LIST",
        "what to compare, with slashes between: default, full, an axis (scalar, method, depth, weight), or "
        "values such as float,textbook,depth=3");
    add_text(command, "--target-error", texts.target_error, "E",
             "find the cheapest with at most this relative RMSE, and prove it at the scene's own size");
    add_text(command, "--runs", texts.runs, "N", "runs of each configuration, 5 to 1000 (5)");
    add_text(command, "--threads", texts.threads, "N",
             "how many work at it, instead of one for each processor");
    add_text(command, "--reference-rays", texts.reference_rays, "N",
             "rays of the reference for each pixel, 1 to 1000000 (100000)");
    command.footer("The reference is kept in ~/.cache/rayscope; after Ctrl-C the same command goes on.\n\n"
                   "Example:\n  rayscope accuracy lens --configs scalar/float,textbook/depth -o cost\n"
                   "  rayscope accuracy --cases\n");
    return made;
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

void refuse_repeated(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 1) throw UsageError(option->get_name() + " is given twice, expected it once");
}

/// Empty only where none was given.
std::string scene_text(const Texts& texts) {
    if (texts.scene && texts.scene->empty())
        throw UsageError(std::string("expected a ") + scene_help + ", found ''");
    return texts.scene.value_or("");
}

RayChoice ray_choice(const Texts& texts) {
    RayChoice choice;
    choice.scene = scene_text(texts);
    if (texts.pixel && texts.ray) throw UsageError("--pixel and --ray exclude each other");
    if (texts.pixel) choice.pixel = parse_pixel(*texts.pixel);
    if (texts.ray) choice.ray = parse_ray(*texts.ray);
    return choice;
}

StepOptions step_options(const Texts& texts) {
    StepOptions options;
    options.choice = ray_choice(texts);
    if (texts.digits) options.digits = parse_count("--digits", *texts.digits, 1, 17);
    options.no_picture = texts.no_png;
    options.picture_asked_for = texts.png.has_value();
    if (texts.no_png && options.picture_asked_for) throw UsageError("--png and --no-png exclude each other");
    if (texts.png) options.picture = *texts.png;
    if (texts.size) options.size = parse_size(*texts.size);
    options.why = texts.why;
    options.compare = texts.compare;
    if (texts.compare && texts.why) throw UsageError("--compare and --why exclude each other");
    if (texts.compare && texts.png)
        throw UsageError("--compare draws no picture: --png has no meaning with it");
    if (texts.compare && texts.size)
        throw UsageError("--compare draws no picture: --size has no meaning with it");
    return options;
}

std::string needed_output(const Texts& texts, const char* command, const char* example) {
    if (!texts.output)
        throw UsageError(std::string(command) + " needs to know where to write: -o " + example);
    return *texts.output;
}

RenderCommandOptions render_options(const Texts& texts) {
    RenderCommandOptions options;
    options.scene = scene_text(texts);
    if (!texts.scene) throw UsageError("render needs a scene: rayscope render SCENE -o image.png");
    options.output = needed_output(texts, "render", "image.png");
    options.statistics = texts.statistics;
    options.configuration = texts.configurations;
    if (texts.size) options.size = parse_size(*texts.size);
    if (texts.threads) options.threads = parse_count("--threads", *texts.threads, 1, 1024);
    return options;
}

/// What measures a scene is no option of the cases.
void refuse_scene_options(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && !option->get_positional() && option->get_name() != "--cases" &&
            option->get_name() != "-o")
            throw UsageError(option->get_name() + " is about a scene, and has no meaning with --cases");
}

CasesOptions cases_options(const Texts& texts) {
    if (texts.scene && texts.scene->empty())
        throw UsageError("--cases: expected a folder of cases, found ''");
    if (texts.output && texts.output->empty()) throw UsageError("-o: expected a folder, found ''");
    return {texts.scene, texts.output};
}

AccuracyCommandOptions accuracy_options(const Texts& texts) {
    AccuracyCommandOptions options;
    options.scene = scene_text(texts);
    if (!texts.scene) throw UsageError("accuracy needs a scene: rayscope accuracy SCENE");
    options.output = texts.output;
    if (options.output && options.output->empty()) throw UsageError("-o: expected a folder, found ''");
    if (texts.configurations) options.configurations = *texts.configurations;
    if (texts.size) options.size = parse_size(*texts.size);
    if (texts.target_error) options.target_error = parse_positive("--target-error", *texts.target_error);
    if (texts.runs) options.runs = parse_count("--runs", *texts.runs, 5, 1000);
    if (texts.threads) options.threads = parse_count("--threads", *texts.threads, 1, 1024);
    if (texts.reference_rays)
        options.reference_rays = parse_count("--reference-rays", *texts.reference_rays, 1, 1000000);
    return options;
}

/// Each on its own while it parses: below a common parent, a scene called like a command would be taken for one.
using Commands = std::vector<CLI::App_p>;

[[noreturn]] void refuse_command(const std::string& word, const Commands& commands) {
    std::vector<std::string> names;
    for (const CLI::App_p& command : commands) names.push_back(command->get_name());
    names.emplace_back("help");
    const std::vector<std::string_view> known(names.begin(), names.end());
    if (word.starts_with('-'))
        throw UsageError("unknown option " + in_quotes(word) + did_you_mean(word, {"--help", "--version"}) +
                         "; rayscope --help lists the commands");
    throw UsageError((word.empty() ? "no command" : "unknown command " + in_quotes(word)) +
                     did_you_mean(word, known) + "; expected " + one_of(known));
}

CLI::App& command_called(const std::string& word, const Commands& commands) {
    for (const CLI::App_p& command : commands)
        if (command->get_name() == word) return *command;
    refuse_command(word, commands);
}

std::string general_help(const Commands& commands) {
    CLI::App app("rayscope records everything that a ray does, and lets you walk through it.", "rayscope");
    app.set_version_flag("--version", RAYSCOPE_VERSION);
    app.footer("`rayscope help COMMAND` tells more about a command.\n\nExample:\n  rayscope step\n");
    for (const CLI::App_p& command : commands) app.add_subcommand(command);
    return app.help();
}

/// What comes before all commands: help, help of a command, the version.
std::optional<Help> general_answer(const Commands& commands, const std::vector<std::string>& words) {
    const bool version = words[0] == "--version";
    if (!version && words[0] != "help" && words[0] != "--help" && words[0] != "-h") return std::nullopt;
    const std::size_t most = version ? 1 : 2;
    if (words.size() > most) throw UsageError("unexpected argument " + in_quotes(words[most]));
    if (version) return Help{"rayscope " RAYSCOPE_VERSION "\n"};
    if (words.size() == 1 || words[1] == "help") return Help{general_help(commands)};
    return Help{command_called(words[1], commands).help("rayscope")};
}

} // namespace

Options parse_options(int count, const char* const* arguments) {
    Texts texts;
    const Commands commands{make_step(texts), make_trace(texts), make_render(texts), make_accuracy(texts)};
    const std::vector<std::string> words(arguments + std::min(count, 1), arguments + count);
    if (words.empty()) refuse_command("", commands);
    if (auto help = general_answer(commands, words)) return *std::move(help);
    CLI::App& command = command_called(words[0], commands);
    command.allow_extras();
    try {
        command.parse(count - 1, arguments + 1);
    } catch (const CLI::CallForHelp&) {
        return Help{command.help("rayscope")};
    } catch (const CLI::ArgumentMismatch& error) {
        const std::string text = error.what(); // "--pixel: …"
        throw UsageError(text.substr(0, text.find(':')) +
                         ": expected a value after it, found none; rayscope " + command.get_name() +
                         " --help tells more");
    } catch (const CLI::ConversionError&) { // only a flag's value is converted there
        throw UsageError((command.get_name() == "step" ? "--no-png" : "--cases") +
                         std::string(" takes no value"));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + "; rayscope " + command.get_name() +
                         " --help tells more");
    }
    refuse_unknown(command);
    refuse_repeated(command);
    if (command.get_name() == "step") return step_options(texts);
    if (command.get_name() == "render") return render_options(texts);
    if (texts.cases) {
        refuse_scene_options(command);
        return cases_options(texts);
    }
    if (command.get_name() == "accuracy") return accuracy_options(texts);
    return TraceOptions{ray_choice(texts), needed_output(texts, "trace", "ray.json")};
}

} // namespace rayscope::cli
