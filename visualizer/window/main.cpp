// rayscope-window: the window of `rayscope view`.

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/warnings.hpp"
#include "visualizer/window/colours.hpp"
#include "visualizer/window/display.hpp"
#include "visualizer/window/main_window.hpp"
#include "visualizer/window/script.hpp"

#include <CLI/CLI.hpp>
#include <QApplication>
#include <QStyleFactory>
#include <QSurfaceFormat>

#include <cstdio>
#include <iostream>

namespace {

using namespace rayscope;

struct Arguments {
    std::string scene;
    std::optional<std::string> pixel, ray, effects, script, size;
};

/// The same on every desktop: light, as the colours of the rays are made for.
void dress(QApplication& app) {
    QApplication::setStyle(QStyleFactory::create("Fusion"));
    QPalette palette(QColor(0xF0, 0xF1, 0xF4), QColor(0xF0, 0xF1, 0xF4));
    palette.setColor(QPalette::Base, Qt::white);
    palette.setColor(QPalette::AlternateBase, window::qt_colour(drawing::panel));
    for (const auto role : {QPalette::Text, QPalette::WindowText, QPalette::ButtonText})
        palette.setColor(role, window::qt_colour(drawing::ink));
    palette.setColor(QPalette::Highlight, window::qt_colour(drawing::highlight));
    palette.setColor(QPalette::HighlightedText, window::qt_colour(drawing::ink));
    palette.setColor(QPalette::Disabled, QPalette::ButtonText, QColor(0x99, 0x99, 0x99));
    palette.setColor(QPalette::Disabled, QPalette::Text, QColor(0x99, 0x99, 0x99));
    QApplication::setPalette(palette);
    QFont font("DejaVu Sans");
    font.setPixelSize(12);
    QApplication::setFont(font);
    app.setStyleSheet("QToolTip { color: #222; background: #ffffe8; border: 1px solid #999; }"
                      "QDockWidget::title { padding: 3px 6px; background: #e2e5ea; }");
}

int show(const Arguments& arguments, window::Desk& desk, int& count, char** words) {
    QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
    format.setSamples(0); // with more, translucent surfaces get lost
    QSurfaceFormat::setDefaultFormat(format);
    QCoreApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QCoreApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QCoreApplication::setOrganizationName("rayscope");
    QCoreApplication::setApplicationName("rayscope");
    QApplication app(count, words);
    dress(app);
    window::MainWindow main(desk, !arguments.script);
    if (arguments.size) {
        const cli::Size size = cli::parse_size(*arguments.size);
        main.resize(size.width, size.height);
    }
    main.show();
    if (!arguments.script) return QApplication::exec();
    return window::run_script(main, *arguments.script, std::cout) ? cli::done : cli::failed;
}

int run(const Arguments& arguments, int& count, char** words) {
    cli::RayChoice choice;
    choice.scene = arguments.scene;
    if (arguments.pixel && arguments.ray) throw cli::UsageError("--pixel and --ray exclude each other");
    if (arguments.pixel) choice.pixel = cli::parse_pixel(*arguments.pixel);
    if (arguments.ray) choice.ray = cli::parse_ray(*arguments.ray);
    choice.effects = arguments.effects;
    if (arguments.size) (void)cli::parse_size(*arguments.size);
    window::Desk desk(choice);
    cli::print_warnings(desk.scene());
    if (!window::has_display()) {
        std::fputs("rayscope: no display to open a window on; without one: rayscope step SCENE, rayscope "
                   "trace SCENE "
                   "-o ray.html, or rayscope step SCENE --png FILE\n",
                   stderr);
        return cli::wrong_usage;
    }
    return show(arguments, desk, count, words);
}

} // namespace

int main(int count, char** words) {
    CLI::App app{"A window to walk through the rays of a scene", "rayscope view"};
    Arguments arguments;
    app.add_option("SCENE", arguments.scene, "A scene file, or the name of a shipped one (glass_bowl)");
    app.add_option("--pixel", arguments.pixel, "X,Y: the pixel whose ray is shown first");
    app.add_option("--ray", arguments.ray, "OX,OY,OZ,DX,DY,DZ: a ray of your own");
    app.add_option("--effects", arguments.effects, "The effects that are simulated, as of rayscope step");
    app.add_option("--size", arguments.size, "WIDTHxHEIGHT of the window");
    app.add_option(
        "--script", arguments.script,
        "A file of actions that are carried out; what the window shows is told as JSON, a line for each");
    app.footer("Example: rayscope view prism");
    try {
        app.parse(count, words);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? cli::done : cli::wrong_usage;
    }
    return cli::guarded([&] { return run(arguments, count, words); });
}
