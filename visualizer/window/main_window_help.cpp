// What the window says of itself.

#include "visualizer/window/main_window.hpp"

#include <QDialog>
#include <QDialogButtonBox>
#include <QTextBrowser>
#include <QVBoxLayout>

#include <algorithm>

namespace rayscope::window {

void MainWindow::show_cheat_sheet() {
    QString rows;
    int count = 0;
    for (const QAction* action : actions()) {
        if (action->shortcut().isEmpty()) continue;
        rows += QString(count % 2 == 0 ? "<tr>" : "") + "<td><b>" +
                action->shortcut().toString().toHtmlEscaped() + "</b>&nbsp;&nbsp;</td><td>" +
                action->data().toString().toHtmlEscaped() + "&nbsp;&nbsp;&nbsp;&nbsp;</td>" +
                (count % 2 == 1 ? "</tr>" : "");
        ++count;
    }
    show_page("cheat_sheet", "Keys",
              "<p>Shift with a letter goes backwards. Arrow keys in the image: the pixel beside "
              "it.</p><table cellpadding='1'>" +
                  rows + "</table>");
}

void MainWindow::show_first_steps() {
    show_page(
        "first_steps", "First steps",
        "<p><b>Which ray?</b> Click a pixel of the image. Its ray and all that it spawns stand in the "
        "recursion tree; a click on one goes there.</p>"
        "<p><b>What happens to it?</b> S is the next event, Shift+S the one before. The panel Ray tells it "
        "in numbers, Refraction draws the angles, and under the picture lies where the ray is inside "
        "of what.</p>"
        "<p><b>Why is a pixel dark?</b> The panel Colour tells where its light comes from and what the "
        "limits dropped; grey rows of the tree are rays that were not followed. The image "
        "\"dropped\" shows where more is lost.</p>"
        "<p><b>Where does it happen?</b> B sets a stop, such as <tt>tir</tt>, <tt>exit</tt>, "
        "<tt>shadow-blocked</tt>, <tt>depth &gt;= 3</tt>; C goes there. Ctrl+F looks for pixels that have "
        "one.</p>"
        "<p><b>What did an octree save?</b> The panel Octree tells it of the current ray. \"Hits by\" "
        "chooses how hits are found; the answer is the same.</p>"
        "<p>All keys: ?. Every command of the terminal: the panel Console, where help lists "
        "them.</p>");
}

void MainWindow::show_page(const char* name, const QString& title, const QString& text) {
    auto* box = new QDialog(this);
    box->setObjectName(name);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setWindowTitle(title);
    auto* page = new QTextBrowser;
    page->setHtml("<h3>" + title + "</h3>" + text);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, box, &QDialog::close);
    auto* column = new QVBoxLayout(box);
    column->addWidget(page, 1);
    column->addWidget(buttons);
    constexpr int width = 720, around = 90;
    page->document()->setTextWidth(width - 50);
    box->resize(width, std::min(int(page->document()->size().height()) + around, height()));
    box->open();
}

} // namespace rayscope::window
