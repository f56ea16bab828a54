#include "visualizer/cli/options.hpp"

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/option_texts.hpp"

#include <algorithm>

namespace rayscope::cli {
namespace {

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

std::optional<StageChoice> asked_stage(const Texts& texts) {
    if (!texts.stage || *texts.stage == "best") return std::nullopt;
    try {
        return stage_choice(*texts.stage);
    } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--stage: ") + error.what());
    }
}

RayChoice ray_choice(const Texts& texts) {
    RayChoice choice;
    choice.scene = scene_text(texts);
    if (texts.pixel && texts.ray) throw UsageError("--pixel and --ray exclude each other");
    if (texts.pixel) choice.pixel = parse_pixel(*texts.pixel);
    if (texts.ray) choice.ray = parse_ray(*texts.ray);
    choice.effects = texts.effects;
    if (texts.sample) {
        if (texts.ray) throw UsageError("--sample is one of a pixel: --ray has none");
        choice.sample = parse_count("--sample", *texts.sample, 0, most_samples - 1);
    }
    choice.by_stage = texts.stage.has_value();
    choice.stage = asked_stage(texts);
    return choice;
}

StepOptions step_options(const Texts& texts) {
    StepOptions options;
    options.choice = ray_choice(texts);
    if (texts.digits) options.digits = parse_count("--digits", *texts.digits, 1, 17);
    options.no_picture = texts.no_png;
    options.all_steps = texts.all_steps;
    options.picture_asked_for = texts.png.has_value() || texts.all_steps;
    if (texts.no_png && texts.png) throw UsageError("--png and --no-png exclude each other");
    if (texts.no_png && texts.all_steps) throw UsageError("--all-steps and --no-png exclude each other");
    if (texts.png) options.picture = *texts.png;
    if (texts.size) options.size = parse_size(*texts.size);
    options.why = texts.why;
    options.compare = texts.compare;
    options.script = texts.script;
    options.json = texts.json;
    options.quiz = texts.quiz;
    if (texts.quiz && texts.script) throw UsageError("--quiz and --script exclude each other");
    for (const auto& [given, name] :
         {std::pair(texts.quiz, "--quiz"), {texts.json, "--json"}, {texts.script.has_value(), "--script"}})
        if (given && (texts.why || texts.compare))
            throw UsageError(std::string(name) + " starts a conversation; --why and --compare only answer");
    if (texts.compare && texts.stage)
        throw UsageError("--compare and --stage exclude each other: other numbers than double stable scan");
    if (texts.compare && texts.why) throw UsageError("--compare and --why exclude each other");
    if (texts.compare && texts.png)
        throw UsageError("--compare draws no picture: --png has no meaning with it");
    if (texts.compare && texts.all_steps)
        throw UsageError("--compare draws no picture: --all-steps has no meaning with it");
    if (texts.compare && texts.size)
        throw UsageError("--compare draws no picture: --size has no meaning with it");
    return options;
}

FindCommandOptions find_options(const Texts& texts) {
    FindCommandOptions options;
    options.scene = scene_text(texts);
    if (!texts.scene) throw UsageError("find needs a scene: rayscope find SCENE --where CONDITION");
    if (!texts.where) throw UsageError("find needs to know what to look for: --where 'tir && depth >= 3'");
    options.where = *texts.where;
    options.by_stage = texts.stage.has_value();
    options.stage = asked_stage(texts);
    options.output = texts.output;
    options.json = texts.json;
    if (texts.size) options.size = parse_size(*texts.size);
    if (texts.listed) options.listed = parse_count("--list", *texts.listed, 0, 100000);
    if (texts.threads) options.threads = parse_count("--threads", *texts.threads, 1, 1024);
    return options;
}

DiffOptions diff_options(const Texts& texts) {
    DiffOptions options;
    options.other = texts.other;
    options.configuration = texts.configurations;
    options.stage = texts.stage;
    if (!texts.scene) throw UsageError("diff needs a scene: rayscope diff SCENE OTHER");
    if (int(texts.other.has_value()) + int(texts.configurations.has_value()) + int(texts.stage.has_value()) !=
        1)
        throw UsageError("diff needs one other run: another scene, --config LIST or --stage NAME");
    Texts ray = texts;
    ray.stage.reset();
    options.choice = ray_choice(ray);
    if (texts.digits) options.digits = parse_count("--digits", *texts.digits, 1, 17);
    return options;
}

std::string needed_output(const Texts& texts, const char* command, const char* example) {
    if (!texts.output)
        throw UsageError(std::string(command) + " needs to know where to write: -o " + example);
    return *texts.output;
}

ExplainOptions explain_options(const Texts& texts) {
    ExplainOptions options;
    options.scene = scene_text(texts);
    if (!texts.scene) throw UsageError("explain needs a scene: rayscope explain SCENE");
    options.effects = texts.effects;
    options.cost = texts.cost;
    options.energy = texts.energy;
    options.output = texts.output;
    if (options.output && options.output->empty()) throw UsageError("-o: expected a folder, found ''");
    for (const auto& [name, given] : {std::pair{"-o", texts.output}, {"--runs", texts.runs}})
        if (given && !texts.cost) throw UsageError(std::string(name) + " has no meaning without --cost");
    if (texts.size) options.size = parse_size(*texts.size);
    if (texts.runs) options.rounds = parse_count("--runs", *texts.runs, 5, 1000);
    if (texts.threads) options.threads = parse_count("--threads", *texts.threads, 1, 1024);
    return options;
}

ExtentsOptions extents_options(const Texts& texts) {
    ExtentsOptions options;
    options.scene = scene_text(texts);
    if (!texts.scene) throw UsageError("extents needs a scene: rayscope extents SCENE -o extents.png");
    options.output = needed_output(texts, "extents", "extents.png");
    if (texts.size) options.size = parse_size(*texts.size);
    return options;
}

RenderCommandOptions render_options(const Texts& texts) {
    RenderCommandOptions options;
    options.scene = scene_text(texts);
    if (!texts.scene) throw UsageError("render needs a scene: rayscope render SCENE -o image.png");
    options.output = needed_output(texts, "render", "image.png");
    options.statistics = texts.statistics;
    options.configuration = texts.configurations;
    options.stage = asked_stage(texts);
    if (texts.heat) options.heat = parse_heat(*texts.heat);
    options.effects = texts.effects;
    options.even_samples = texts.even_samples;
    if (texts.samples) options.samples = parse_count("--samples", *texts.samples, 1, most_samples);
    if (texts.size) options.size = parse_size(*texts.size);
    if (texts.threads) options.threads = parse_count("--threads", *texts.threads, 1, 1024);
    return options;
}

ExportOptions export_options(const Texts& texts) {
    if (!texts.scene) throw UsageError("export needs a scene: rayscope export SCENE -o scene.pov");
    return {scene_text(texts), needed_output(texts, "export", "scene.pov")};
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
    const Commands commands = make_commands(texts);
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
        for (const std::string& word : words)
            if (const auto value = word.find('='); word.starts_with("--") && value != std::string::npos)
                throw UsageError(word.substr(0, value) + " takes no value");
        throw UsageError("a flag takes no value; rayscope " + command.get_name() + " --help tells more");
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + "; rayscope " + command.get_name() +
                         " --help tells more");
    }
    refuse_unknown(command);
    refuse_repeated(command);
    if (command.get_name() == "step") return step_options(texts);
    if (command.get_name() == "find") return find_options(texts);
    if (command.get_name() == "diff") return diff_options(texts);
    if (command.get_name() == "render") return render_options(texts);
    if (command.get_name() == "explain") return explain_options(texts);
    if (command.get_name() == "extents") return extents_options(texts);
    if (command.get_name() == "export") return export_options(texts);
    if (texts.cases) {
        refuse_scene_options(command);
        return cases_options(texts);
    }
    if (command.get_name() == "accuracy") return accuracy_options(texts);
    return TraceOptions{ray_choice(texts), needed_output(texts, "trace", "ray.json")};
}

} // namespace rayscope::cli
