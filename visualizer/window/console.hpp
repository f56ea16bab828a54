#pragma once
// The terminal's debugger inside the window: the same commands, the same answers.

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QStringList>

#include <functional>

namespace rayscope::window {

class Console : public QWidget {
public:
    Console();
    std::function<void(const QString& line)> on_line;

    void add(const QString& prompt, const QString& line, const QString& answer);
    void set_prompt(const QString& prompt);
    void begin(const QString& text); ///< puts the text into the line, and the keyboard there
    void enter(const QString& line); ///< as if typed
    [[nodiscard]] QString log() const { return log_.toPlainText(); }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void show_end();

    QPlainTextEdit log_;
    QLineEdit line_;
    QStringList history_;
    int at_ = 0;
};

/// A font in which columns stay columns.
[[nodiscard]] QFont fixed_font();

} // namespace rayscope::window
