#include "visualizer/window/script.hpp"

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/script.hpp"
#include "visualizer/window/main_window.hpp"

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPushButton>

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>

namespace rayscope::window {
namespace {

constexpr int longest_wait = 60'000; // milliseconds

void work_off(MainWindow& window) {
    QApplication::processEvents();
    window.space.finish();
    QApplication::processEvents();
}

bool wait_for(MainWindow& window) {
    QElapsedTimer clock;
    clock.start();
    while (!window.complete() && clock.elapsed() < longest_wait)
        QApplication::processEvents(QEventLoop::AllEvents, 10);
    work_off(window);
    return window.complete();
}

void mouse(QWidget& widget, QEvent::Type type, QPoint at, Qt::MouseButtons held,
           Qt::KeyboardModifiers keys = Qt::NoModifier) {
    const Qt::MouseButton button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, at, widget.mapToGlobal(at), button, held, keys);
    QApplication::sendEvent(&widget, &event);
}
void click(QWidget& widget, QPoint at) {
    mouse(widget, QEvent::MouseButtonPress, at, Qt::LeftButton);
    mouse(widget, QEvent::MouseButtonRelease, at, Qt::NoButton);
}
void drag(QWidget& widget, QPoint from, QPoint to, int steps, MainWindow& window,
          Qt::KeyboardModifiers keys = Qt::NoModifier) {
    mouse(widget, QEvent::MouseButtonPress, from, Qt::LeftButton, keys);
    for (int i = 1; i <= steps; ++i) {
        mouse(widget, QEvent::MouseMove, from + (to - from) * i / steps, Qt::LeftButton, keys);
        work_off(window);
    }
    mouse(widget, QEvent::MouseButtonRelease, to, Qt::NoButton, keys);
}

using Words = std::istringstream;
using Deed = std::function<bool(MainWindow&, Words&)>;

template <typename T> T next(Words& words) {
    T value{};
    if (!(words >> value)) throw cli::UsageError("expected another word");
    return value;
}
std::string rest(Words& words) {
    std::string text;
    std::getline(words >> std::ws, text);
    return text;
}

bool pick(MainWindow& w, Words& words) {
    const int x = next<int>(words), y = next<int>(words);
    click(w.image, w.image.place_of(x, y));
    return true;
}
bool scrub(MainWindow& w, Words& words) {
    const int x0 = next<int>(words), y0 = next<int>(words), x1 = next<int>(words), y1 = next<int>(words);
    drag(w.image, w.image.place_of(x0, y0), w.image.place_of(x1, y1), 5, w);
    return true;
}
bool click_row(MainWindow& w, Words& words) {
    const auto* model = dynamic_cast<const RayTreeModel*>(w.tree.model());
    const QModelIndex index = model->index_of(next<int>(words));
    if (!index.isValid()) return false;
    w.tree.scrollTo(index);
    click(*w.tree.viewport(), w.tree.visualRect(index).center());
    return true;
}
bool click_ray(MainWindow& w, Words& words) {
    const auto place = w.space.place_of(next<int>(words));
    if (place) click(w.space, *place);
    return place.has_value();
}
/// Catches the first handle of a kind, or the one of that index, and drags it by some pixels.
bool drag_handle(MainWindow& w, Handle::Kind kind, std::size_t index, Words& words) {
    const int dx = next<int>(words), dy = next<int>(words);
    for (const Handle& handle : w.space.handles())
        if (handle.kind == kind && handle.index == index)
            if (const auto place = w.space.place_of(handle)) {
                drag(w.space, place->toPoint(), place->toPoint() + QPoint(dx, dy), 4, w);
                return true;
            }
    return false;
}
bool drag_light(MainWindow& w, Words& words) {
    const auto light = next<std::size_t>(words);
    return drag_handle(w, Handle::Kind::light, light, words);
}
bool drag_solid(MainWindow& w, Words& words) {
    if (!w.objects.choose(next<std::string>(words)) || !w.space.grip()) return false;
    work_off(w);
    return drag_handle(w, Handle::Kind::generic, w.space.grip()->generic, words);
}
/// Ctrl + drag in the 3D view, from shares of its width and height.
bool pull(MainWindow& w, Words& words) {
    const double x = next<double>(words), y = next<double>(words);
    const int dx = next<int>(words), dy = next<int>(words);
    const QPoint from(int(x * w.space.width()), int(y * w.space.height()));
    drag(w.space, from, from + QPoint(dx, dy), 4, w, Qt::ControlModifier);
    return w.space.grip().has_value();
}
bool orbit(MainWindow& w, Words& words) {
    const int dx = next<int>(words), dy = next<int>(words);
    // In a corner, where there is no light to be caught.
    drag(w.space, {4, 4}, {4 + dx, 4 + dy}, 4, w);
    return true;
}
bool sweep(MainWindow& w, Words& words) {
    const double share = next<double>(words);
    click(*w.lanes.viewport(), {int(w.lanes.viewport()->width() * share), w.lanes.viewport()->height() / 2});
    return true;
}
bool object(MainWindow& w, Words& words) {
    const auto name = next<std::string>(words), what = next<std::string>(words);
    auto* button = w.objects.findChild<QPushButton*>(QString::fromStdString("object_" + what));
    if (button == nullptr || !w.objects.choose(name)) return false;
    button->click();
    return true;
}
/// Until another hand, at the real keyboard and mouse, has brought the cursor to this ray and event.
bool until(MainWindow& w, Words& words) {
    const int ray = next<int>(words), event = next<int>(words);
    QElapsedTimer clock;
    clock.start();
    while (w.desk.walk().cursor().spot() != Spot{ray, event} && clock.elapsed() < longest_wait / 2)
        QApplication::processEvents(QEventLoop::AllEvents, 10);
    return w.desk.walk().cursor().spot() == Spot{ray, event};
}
bool steps(MainWindow& w, Words& words) {
    const int count = next<int>(words);
    QElapsedTimer clock;
    clock.start();
    double longest = 0;
    for (int i = 0; i < count; ++i) {
        const double before = double(clock.nsecsElapsed()) / 1e6;
        (void)w.press("N");
        work_off(w);
        longest = std::max(longest, double(clock.nsecsElapsed()) / 1e6 - before);
    }
    std::fprintf(stderr, "%d steps: %.1f a second, the longest %.1f ms\n", count,
                 count * 1e3 / double(clock.elapsed()), longest);
    return true;
}

const std::map<std::string, Deed, std::less<>>& deeds() {
    static const std::map<std::string, Deed, std::less<>> table{
        {"pick", pick},
        {"scrub", scrub},
        {"row", click_row},
        {"ray", click_ray},
        {"light", drag_light},
        {"solid", drag_solid},
        {"pull", pull},
        {"start",
         [](MainWindow& w, Words& words) { return drag_handle(w, Handle::Kind::ray_start, 0, words); }},
        {"end", [](MainWindow& w, Words& words) { return drag_handle(w, Handle::Kind::ray_end, 0, words); }},
        {"orbit", orbit},
        {"sweep", sweep},
        {"object", object},
        {"steps", steps},
        {"until", until},
        {"key", [](MainWindow& w, Words& words) { return w.press(QString::fromStdString(rest(words))); }},
        {"type",
         [](MainWindow& w, Words& words) {
             w.console.enter(QString::fromStdString(rest(words)));
             return true;
         }},
        {"stop", [](MainWindow& w, Words& words) { return w.command("break " + rest(words)); }},
        {"slide",
         [](MainWindow& w, Words& words) {
             const auto part = next<std::string>(words);
             return w.materials.slide(part, next<double>(words));
         }},
        {"material",
         [](MainWindow& w, Words& words) {
             auto* names = w.materials.findChild<QComboBox*>("material");
             const int index = names->findText(QString::fromStdString(rest(words)));
             if (index >= 0) names->setCurrentIndex(index);
             return index >= 0;
         }},
        {"weight",
         [](MainWindow& w, Words& words) {
             w.weights.setValue(next<int>(words));
             return true;
         }},
        {"heat",
         [](MainWindow& w, Words& words) {
             w.choose_heat(next<int>(words));
             return true;
         }},
        {"stage",
         [](MainWindow& w, Words& words) {
             w.choose_stage(rest(words));
             return true;
         }},
        {"level",
         [](MainWindow& w, Words& words) {
             w.octree.levels.setValue(next<int>(words));
             return true;
         }},
        {"tab",
         [](MainWindow& w, Words& words) {
             w.show_tab(QString::fromStdString(rest(words)));
             return true;
         }},
        {"open",
         [](MainWindow& w, Words& words) {
             w.open_scene(QString::fromStdString(rest(words)));
             return true;
         }},
        {"resize",
         [](MainWindow& w, Words& words) {
             const int width = next<int>(words);
             w.resize(width, next<int>(words));
             return true;
         }},
        {"shot",
         [](MainWindow& w, Words& words) { return w.grab().save(QString::fromStdString(rest(words))); }},
        {"wait", [](MainWindow& w, Words&) { return wait_for(w); }},
        {"state", [](MainWindow&, Words&) { return true; }}};
    return table;
}

} // namespace

bool run_script(MainWindow& window, const std::string& file, std::ostream& out) {
    bool all = true;
    for (const cli::ScriptLine& line : cli::read_script(file)) {
        Words words(line.text);
        std::string name;
        words >> name;
        const auto found = deeds().find(name);
        Outcome outcome{line.text};
        QElapsedTimer clock;
        clock.start();
        try {
            outcome.ok = found != deeds().end() && found->second(window, words);
        } catch (const cli::UsageError&) { // told as not done
        }
        work_off(window);
        outcome.milliseconds = double(clock.nsecsElapsed()) / 1e6;
        all = all && outcome.ok;
        out << report_of(window, outcome) << std::endl;
    }
    return all;
}

} // namespace rayscope::window
