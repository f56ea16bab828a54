#include "visualizer/window/main_window.hpp"

#include "visualizer/cli/failure.hpp"

#include <QCloseEvent>
#include <QFileDialog>
#include <QMessageBox>
#include <QSettings>
#include <QStatusBar>

#include <algorithm>
#include <utility>

namespace rayscope::window {
MainWindow::MainWindow(Desk& given, bool remember)
    : desk(given),
      objects(space),
      maker_(this, [this](const MadeImage& made) { image.show_image(made); }),
      remember_(remember) {
    setObjectName("rayscope");
    make_docks();
    make_menus();
    make_toolbar();
    make_options();
    said_.setTextFormat(Qt::PlainText);
    said_.setMinimumWidth(1); // a long message is cut, and makes no window wider
    statusBar()->addWidget(&said_, 1);
    statusBar()->addPermanentWidget(&pixel_);
    link();
    link_changes();
    resize(1600, 1000);
    if (remember_) {
        const QSettings settings;
        restoreGeometry(settings.value("geometry").toByteArray());
        sized_ = restoreState(settings.value("state").toByteArray());
    }
    scene_changed();
}

void MainWindow::link() {
    desk.on_scene = [this] { scene_changed(); };
    desk.on_trace = [this] { trace_changed(); };
    desk.on_move = [this] { moved(); };
    image.on_pick = [this](int x, int y) { command("pixel " + std::to_string(x) + "," + std::to_string(y)); };
    tree.on_ray = [this](int ray) { command("goto " + std::to_string(ray)); };
    space.on_ray = [this](int ray) { command("goto " + std::to_string(ray)); };
    lanes.on_sweep = [this](std::optional<double> t) { space.set_sweep(t); };
    console.on_line = [this](const QString& line) {
        typing_ = true;
        command(line.toStdString());
        typing_ = false;
    };
    QObject::connect(&moments, &QSlider::valueChanged, this, [this](int moment) {
        if (showing_) return;
        const Spot spot = desk.walk().timeline().at(std::size_t(moment));
        command("goto " + std::to_string(spot.ray) + "." + std::to_string(spot.event));
    });
    QObject::connect(&weights, &QSlider::valueChanged, this, [this](int value) {
        const double least = least_weight();
        space.set_least_weight(least);
        tree.show_trace(&shown(), least);
        tree.show_ray(desk.ray());
        say(value == 0 ? "All rays are shown"
                       : QString("Rays below a weight of %1 are hidden: %2")
                             .arg(least, 0, 'g', 2)
                             .arg(tree.left_out()));
    });
    QObject::connect(&play_timer_, &QTimer::timeout, this, [this] {
        const std::size_t before = desk.walk().cursor().moment();
        command("step");
        const bool stopped =
            !desk.walk().stops().at(desk.walk().walked(), desk.walk().cursor().moment()).empty();
        if (stopped || desk.walk().cursor().moment() == before) play(false);
    });
    QObject::connect(&tabs, &QTabWidget::currentChanged, this, [this] { show_octree(); });
    octree.on_level = [this](int level) { space.set_deepest_cell(level); };
    // An image for each of the numbers that a slider runs through would never be finished.
    image_timer_.setSingleShot(true);
    QObject::connect(&image_timer_, &QTimer::timeout, this, [this] { make_image(); });
    details.viewport()->installEventFilter(this);
}

/// From 10⁻⁴ to 1, by decades; at the left end nothing is left out.
double MainWindow::least_weight() const {
    return weights.value() == 0 ? 0 : std::pow(10.0, -4 + 4.0 * weights.value() / 100);
}

bool MainWindow::command(const std::string& line) {
    if (!typing_ && is_asked()) return false;
    const QString prompt = QString::fromStdString(desk.session().prompt());
    const cli::Reply reply = desk.command(line);
    const QString answer = QString::fromStdString(reply.text);
    if (typing_) {
        console.add(prompt, QString::fromStdString(line), answer);
        console.set_prompt(QString::fromStdString(desk.session().prompt()));
    }
    if (desk.session().ended()) close();
    const QString first = answer.section('\n', 0, 0, QString::SectionSkipEmpty);
    const bool stayed = answer.count('\n') <= 1;
    if (!reply.ok || (stayed && !typing_))
        say(first, !reply.ok);
    else if (reply.command == "continue" || reply.command == "reverse-continue")
        say(!desk.walk().reasons().empty() ? first
            : desk.walk().stops().all().empty()
                ? "There is no stop yet: B sets one"
                : "No stop was met on the way: Ctrl+F looks for pixels with one");
    else
        say({});
    show_stops();
    if (reply.command == "find") desk.session().found() ? show_found() : forget_found();
    return reply.ok;
}

bool MainWindow::is_asked() {
    if (!desk.session().quizzing()) return false;
    say("Answer in the console first; quit ends the quiz", true);
    show_tab("Console");
    return true;
}

void MainWindow::make_image() {
    const int index = overlay_.currentIndex();
    const bool heat = index > 0 && !shows_found();
    maker_.make(desk.bench(), heat ? std::optional(Heat(index - 1)) : std::nullopt);
}

bool MainWindow::complete() const {
    return image.complete() && !maker_.busy() && !image_timer_.isActive() && space.complete();
}

void MainWindow::say(const QString& text, bool wrong) {
    // In a label of its own: what a status bar shows for a while is gone when the mouse moves over a button.
    said_.setStyleSheet(wrong ? "color: #a02000; font-weight: bold;" : "");
    said_.setText(text);
}

void MainWindow::open_scene(const QString& file) {
    if (!may_leave()) return;
    try {
        frame_next_ = true;
        desk.open(file.toStdString());
        say("Opened " + QString::fromStdString(desk.file().string()));
    } catch (const std::exception& error) {
        frame_next_ = false;
        say(error.what(), true);
    }
}

bool MainWindow::may_leave() {
    if (!desk.changed() || !remember_) return true;
    const auto answer = QMessageBox::question(this, "rayscope", "The scene was changed. Save it?",
                                              QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    if (answer == QMessageBox::Save) save();
    return answer != QMessageBox::Cancel && (answer == QMessageBox::Discard || !desk.changed());
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (!std::exchange(sized_, true)) size_docks();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!may_leave()) return event->ignore();
    if (remember_) {
        QSettings settings;
        settings.setValue("geometry", saveGeometry());
        settings.setValue("state", saveState());
    }
    event->accept();
}

/// The texts have the terminal's 80 columns: the letters are as large as the panel lets them be.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (watched == details.viewport() && event->type() == QEvent::Resize) {
        constexpr int columns = 81;
        QFont font = fixed_font();
        for (int size = 15; size >= 10; --size) {
            font.setPixelSize(size);
            if (QFontMetrics(font).horizontalAdvance(QString(columns, '0')) <=
                details.viewport()->width() - 8)
                break;
        }
        for (QPlainTextEdit* text : {&details, &octree.words, &colours}) text->setFont(font);
    }
    return QMainWindow::eventFilter(watched, event);
}

} // namespace rayscope::window
