// rayscope-view: the part of rayscope that needs VTK. `rayscope` runs it for pictures and ParaView files.

#include "visualizer/drawing/accuracy_chart.hpp"
#include "visualizer/drawing/animation.hpp"
#include "visualizer/drawing/effects_chart.hpp"
#include "visualizer/drawing/extents_picture.hpp"
#include "visualizer/drawing/growth_chart.hpp"
#include "visualizer/drawing/heat_map.hpp"
#include "visualizer/drawing/picture.hpp"
#include "visualizer/drawing/vtm.hpp"
#include "visualizer/drawing/write_png.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iostream>
#include <iterator>
#include <optional>

namespace {

using namespace rayscope;

struct Arguments {
    std::string scene, trace, output, size, measurement, map, title;
    int ray = none;
};

void add_files(CLI::App& command, Arguments& arguments) {
    command.add_option("--scene", arguments.scene, "The scene file (.toml or .nff) that the trace is of")
        ->required();
    command.add_option("--trace", arguments.trace, "The trace (.json), as `rayscope trace` writes it")
        ->required();
    command.add_option("-o,--output", arguments.output, "The file to write")->required();
}

Trace read_trace(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path, {}, "can't be read");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    try {
        return trace_from_json(nlohmann::json::parse(text));
    } catch (const std::exception& error) {
        throw InputError(path, {}, error.what());
    }
}

/// WIDTHxHEIGHT, or nothing.
std::optional<drawing::PictureSize> size_in(const std::string& text) {
    drawing::PictureSize size;
    char x = 0, rest = 0;
    const int read = std::sscanf(text.c_str(), "%5d%c%5d%c", &size.width, &x, &size.height, &rest);
    if (read != 3 || (x != 'x' && x != 'X')) return std::nullopt;
    return size;
}

drawing::PictureSize parse_size(const std::string& text) {
    if (text.empty()) return {};
    const auto size = size_in(text);
    if (!size || !size->valid())
        throw InputError("--size", {},
                         "'" + text +
                             "' is no picture size: expected WIDTHxHEIGHT between 480x320 and 7680x4320");
    return *size;
}

void draw(const Arguments& arguments) {
    const drawing::PictureSize size = parse_size(arguments.size);
    const Trace trace = read_trace(arguments.trace);
    const int rays = int(trace.rays.size());
    if (arguments.ray != none && (arguments.ray < 0 || arguments.ray >= rays))
        throw InputError("--ray", {},
                         "there is no ray " + std::to_string(arguments.ray) +
                             ": this trace has the rays 0 … " + std::to_string(rays - 1));
    drawing::write_picture(open(arguments.scene), trace, arguments.output, {size, arguments.ray});
}

void draw_all(const Arguments& arguments, bool animated) {
    const drawing::PictureSize size = parse_size(arguments.size);
    const Trace trace = read_trace(arguments.trace);
    const Workbench bench = open(arguments.scene);
    if (animated)
        drawing::write_animation(bench, trace, arguments.output, size);
    else
        for (const auto& file : drawing::write_all_pictures(bench, trace, arguments.output, size))
            std::cout << file.string() << '\n';
}

void draw_heat(const Arguments& arguments) {
    check_writable(arguments.output);
    const Map map = read_map(arguments.map);
    drawing::write_png(drawing::draw_heat_map(map, arguments.title, drawing::end_of_scale(map)),
                       arguments.output);
}

void draw_extents(const Arguments& arguments) {
    check_writable(arguments.output);
    const Workbench bench = open(arguments.scene);
    RenderOptions options;
    if (!arguments.size.empty()) {
        const auto size = size_in(arguments.size);
        if (!size || size->width < 1 || size->height < 1)
            throw InputError("--size", {}, "'" + arguments.size + "' is no size: expected WIDTHxHEIGHT");
        options.width = size->width;
        options.height = size->height;
    }
    const RenderResult result = render(bench, options);
    const std::string name = std::filesystem::path(arguments.scene).stem().string();
    drawing::write_png(
        drawing::draw_extents(screen_extents(bench, options.width, options.height), result.image, name),
        arguments.output);
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"Pictures and ParaView files of traced rays", "rayscope-view"};
    app.require_subcommand(1);
    Arguments arguments;
    CLI::App* png = app.add_subcommand("png", "Draws the trace as a picture");
    add_files(*png, arguments);
    png->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels (1280x720)");
    png->add_option("--ray", arguments.ray, "The current ray: its path is drawn thick, the others as ghosts");
    png->footer("Example: rayscope-view png --scene bowl.toml --trace bowl.json -o bowl.png --ray 3");
    CLI::App* pngs = app.add_subcommand("pngs", "Draws a picture for each ray, with that ray in front");
    add_files(*pngs, arguments);
    pngs->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels (1280x720)");
    pngs->footer("Example: rayscope-view pngs --scene bowl.toml --trace bowl.json -o bowl.png makes "
                 "bowl-0.png, bowl-1.png, …");
    CLI::App* webp = app.add_subcommand("webp", "Draws the same pictures as one animation");
    add_files(*webp, arguments);
    webp->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels (1280x720)");
    webp->footer("Example: rayscope-view webp --scene bowl.toml --trace bowl.json -o bowl.webp");
    CLI::App* vtm = app.add_subcommand("vtm", "Writes the trace and the surfaces for ParaView");
    add_files(*vtm, arguments);
    vtm->footer("Example: rayscope-view vtm --scene bowl.toml --trace bowl.json -o bowl.vtm");
    CLI::App* accuracy = app.add_subcommand("accuracy", "Draws what `rayscope accuracy -o FOLDER` measured");
    accuracy->add_option("FILE", arguments.measurement, "accuracy.json; the pictures appear beside it")
        ->required();
    accuracy->add_option("--size", arguments.size, "WIDTHxHEIGHT of the chart in pixels (1280x720)");
    accuracy->footer("Example: rayscope-view accuracy cost/accuracy.json");
    CLI::App* heat = app.add_subcommand("heat", "Draws a map of one number for each pixel, with its scale");
    heat->add_option("FILE", arguments.map, "A .pfm of one channel")->required();
    heat->add_option("--title", arguments.title, "What the numbers are");
    heat->add_option("-o,--output", arguments.output, "The file to write")->required();
    heat->footer("Example: rayscope-view heat tests.pfm --title \"tests of generics\" -o tests.png");
    CLI::App* extents = app.add_subcommand("extents", "Draws projective extents and tiles over the image");
    extents->add_option("--scene", arguments.scene, "The scene file")->required();
    extents->add_option("-o,--output", arguments.output, "The file to write")->required();
    extents->add_option("--size", arguments.size, "WIDTHxHEIGHT of the image in pixels (the scene's)");
    extents->footer("Example: rayscope-view extents --scene bowl.toml -o extents.png");
    CLI::App* stages = app.add_subcommand("stages", "Draws what `rayscope bench stages -o FOLDER` measured");
    stages->add_option("FILE", arguments.measurement, "growth.json; stages.png appears beside it")
        ->required();
    stages->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels (1280x720)");
    stages->footer("Example: rayscope-view stages stages/growth.json");
    CLI::App* effects =
        app.add_subcommand("effects", "Draws what `rayscope explain --cost -o FOLDER` measured");
    effects->add_option("FILE", arguments.measurement, "effects.json; effects.png appears beside it")
        ->required();
    effects->add_option("--size", arguments.size, "WIDTHxHEIGHT in pixels (1280x720)");
    effects->footer("Example: rayscope-view effects cost/effects.json");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    try {
        if (*png) draw(arguments);
        if (*pngs) draw_all(arguments, false);
        if (*webp) draw_all(arguments, true);
        if (*accuracy) drawing::write_accuracy_pictures(arguments.measurement, parse_size(arguments.size));
        if (*heat) draw_heat(arguments);
        if (*effects) drawing::write_effects_chart(arguments.measurement, parse_size(arguments.size));
        if (*extents) draw_extents(arguments);
        if (*stages) drawing::write_growth_chart(arguments.measurement, parse_size(arguments.size));
        if (*vtm) drawing::write_vtm(open(arguments.scene), read_trace(arguments.trace), arguments.output);
    } catch (const InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "rayscope-view: " << error.what() << '\n';
        return 1;
    }
    return 0;
}
