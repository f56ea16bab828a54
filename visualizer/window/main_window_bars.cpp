// The two bars above: moves, and what is shown.

#include "visualizer/window/main_window.hpp"

#include <QMenu>
#include <QStyle>
#include <QToolButton>

namespace rayscope::window {

void MainWindow::make_toolbar() {
    auto* bar = new QToolBar("Walk");
    bar->setObjectName("bar_walk");
    bar->setMovable(false);
    addToolBar(bar);
    const auto icon = [this](QStyle::StandardPixmap which) { return style()->standardIcon(which); };
    const auto add = [&](const char* name, std::optional<QStyle::StandardPixmap> picture) {
        for (QAction* action : actions())
            if (action->objectName() == name) {
                if (picture) action->setIcon(icon(*picture));
                bar->addAction(action);
            }
    };
    add("goto start", QStyle::SP_MediaSkipBackward);
    add("reverse-step", QStyle::SP_MediaSeekBackward);
    add("play", QStyle::SP_MediaPlay);
    add("step", QStyle::SP_MediaSeekForward);
    add("goto end", QStyle::SP_MediaSkipForward);
    speed_.setRange(0.5, 60);
    speed_.setValue(4);
    speed_.setDecimals(1);
    speed_.setSuffix(" /s");
    speed_.setObjectName("speed");
    speed_.setToolTip("Steps a second while it plays");
    speed_.setFocusPolicy(Qt::ClickFocus);
    QObject::connect(&speed_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
                     [this](double speed) {
                         if (playing()) play_timer_.start(int(1000 / speed));
                     });
    bar->addWidget(&speed_);
    bar->addSeparator();
    for (const char* name : {"back", "next", "in", "over", "out"}) add(name, std::nullopt);
    bar->addSeparator();
    for (const char* name : {"reverse-continue", "continue"}) add(name, std::nullopt);
    bar->addSeparator();
    moments.setOrientation(Qt::Horizontal);
    moments.setObjectName("moments");
    moments.setAccessibleName("Moment in time");
    moments.setToolTip("All events, in time");
    moments.setMinimumWidth(80);
    moments.setFocusPolicy(Qt::ClickFocus);
    bar->addWidget(&moments);
}

void MainWindow::make_options() {
    addToolBarBreak();
    auto* bar = new QToolBar("Show");
    bar->setObjectName("bar_show");
    bar->setMovable(false);
    addToolBar(bar);
    bar->addWidget(new QLabel(" Stop where "));
    stop_.setObjectName("stop");
    stop_.setPlaceholderText("tir && depth >= 3");
    stop_.setToolTip(
        "A condition of the terminal's language; Enter adds it. Console: info breakpoints, delete N");
    stop_.setMaximumWidth(170);
    QObject::connect(&stop_, &QLineEdit::returnPressed, this, [this] {
        if (command("break " + stop_.text().toStdString())) {
            say("Stops where " + stop_.text() + ": C continues to there, Shift+C back");
            stop_.clear();
            stop_.clearFocus();
        }
    });
    bar->addWidget(&stop_);
    stops_.setObjectName("stops");
    stops_.setPopupMode(QToolButton::InstantPopup);
    stops_.setToolTip("The stops that are set; a click on one takes it away");
    stops_.setFocusPolicy(Qt::ClickFocus);
    auto* stops = new QMenu(&stops_);
    QObject::connect(stops, &QMenu::aboutToShow, this, [this, stops] {
        stops->clear();
        for (const StopPoint& point : desk.walk().stops().all())
            stops->addAction(QString("✕  %1").arg(QString::fromStdString(point.expression.text())),
                             [this, number = point.number] { command("delete " + std::to_string(number)); });
    });
    stops_.setMenu(stops);
    bar->addWidget(&stops_);
    bar->addSeparator();
    bar->addWidget(new QLabel(" Image "));
    overlay_.setObjectName("overlay");
    overlay_.addItem("as it is");
    for (const HeatName& heat : heat_names) {
        overlay_.addItem(QString::fromUtf8(heat.name.data()));
        overlay_.setItemData(overlay_.count() - 1, QString::fromUtf8(heat.meaning.data()), Qt::ToolTipRole);
    }
    overlay_.setToolTip(
        "The image, or what each of its pixels costs, or which rays bring its light; after find (Ctrl+F), "
        "also what it found");
    overlay_.setFocusPolicy(Qt::ClickFocus);
    QObject::connect(&overlay_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
        image.show_found(shows_found() ? desk.session().found() : std::nullopt);
        make_image();
    });
    bar->addWidget(&overlay_);
    bar->addSeparator();
    bar->addWidget(new QLabel(" Hits by "));
    stage_.setObjectName("stage");
    stage_.addItems({"every object", "octree", "bvh", "extents", "projective"});
    stage_.setToolTip("How hits are found. A stage shows where it looks, and tests only what lies there");
    stage_.setFocusPolicy(Qt::ClickFocus);
    QObject::connect(&stage_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this](int index) {
        change([this, index] {
            if (index == 0)
                desk.choose_stage(std::nullopt, false);
            else
                desk.choose_stage(stage_choice(stage_.currentText().toStdString()), true);
        });
    });
    bar->addWidget(&stage_);
    bar->addSeparator();
    bar->addWidget(new QLabel(" Hide rays below "));
    weights.setOrientation(Qt::Horizontal);
    weights.setObjectName("weights");
    weights.setAccessibleName("Least weight of the rays shown");
    weights.setRange(0, 100);
    weights.setMaximumWidth(90);
    weights.setToolTip("Rays of less weight are hidden, in the tree and in 3D: left none, right 1");
    weights.setFocusPolicy(Qt::ClickFocus);
    bar->addWidget(&weights);
    bar->addSeparator();
    place_.setObjectName("place");
    place_.setTextFormat(Qt::RichText);
    bar->addWidget(&place_);
}

void MainWindow::show_stops() {
    const std::size_t count = desk.walk().stops().all().size();
    stops_.setEnabled(count > 0);
    stops_.setText(count == 0   ? QString("no stops")
                   : count == 1 ? QString("1 stop")
                                : QString("%1 stops").arg(count));
}

void MainWindow::play(bool on) {
    if (on)
        play_timer_.start(int(1000 / speed_.value()));
    else
        play_timer_.stop();
    play_->setIcon(style()->standardIcon(on ? QStyle::SP_MediaPause : QStyle::SP_MediaPlay));
}

void MainWindow::choose_heat(int index) { overlay_.setCurrentIndex(index); }

bool MainWindow::shows_found() const { return overlay_.currentIndex() > int(heat_names.size()); }

void MainWindow::show_found() {
    const int entry = int(heat_names.size()) + 1;
    if (overlay_.count() == entry) overlay_.addItem("what was found");
    image.show_found(desk.session().found());
    overlay_.setCurrentIndex(entry);
}

void MainWindow::forget_found() {
    if (shows_found()) overlay_.setCurrentIndex(0);
    overlay_.removeItem(int(heat_names.size()) + 1); // if it is there
}

void MainWindow::choose_stage(const std::string& stage) {
    const int index = stage_.findText(QString::fromStdString(stage));
    if (index >= 0) stage_.setCurrentIndex(index);
}

} // namespace rayscope::window
