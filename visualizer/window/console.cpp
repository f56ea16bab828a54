#include "visualizer/window/console.hpp"

#include <QKeyEvent>
#include <QScrollBar>
#include <QVBoxLayout>

#include <algorithm>

namespace rayscope::window {

QFont fixed_font() {
    QFont font("DejaVu Sans Mono");
    font.setStyleHint(QFont::Monospace);
    font.setPixelSize(12);
    return font;
}

Console::Console() {
    setObjectName("console");
    log_.setReadOnly(true);
    log_.setFont(fixed_font());
    log_.setObjectName("console_log");
    log_.setMaximumBlockCount(5000);
    line_.setFont(fixed_font());
    line_.setObjectName("console_line");
    line_.setMaxLength(8000);
    line_.setPlaceholderText("a command of the terminal: help lists them");
    line_.installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    column->addWidget(&log_, 1);
    column->addWidget(&line_);
    QObject::connect(&line_, &QLineEdit::returnPressed, this, [this] { enter(line_.text()); });
}

void Console::set_prompt(const QString& prompt) { line_.setToolTip(prompt); }

void Console::enter(const QString& line) {
    line_.clear();
    if (!line.isEmpty()) history_ << line;
    at_ = int(history_.size());
    if (on_line) on_line(line);
}

void Console::add(const QString& prompt, const QString& line, const QString& answer) {
    log_.appendPlainText(prompt + line + "\n" + answer.trimmed());
    show_end();
}

void Console::show_end() { log_.verticalScrollBar()->setValue(log_.verticalScrollBar()->maximum()); }

void Console::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    show_end(); // what came while another panel was seen
}

void Console::begin(const QString& text) {
    line_.setText(text);
    line_.setFocus();
}

bool Console::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Up || key == Qt::Key_Down) {
            at_ = std::clamp(at_ + (key == Qt::Key_Up ? -1 : 1), 0, int(history_.size()));
            line_.setText(at_ < int(history_.size()) ? history_[at_] : QString());
            return true;
        }
        if (key == Qt::Key_Escape) {
            line_.clearFocus();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace rayscope::window
