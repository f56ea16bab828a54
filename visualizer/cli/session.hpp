#pragma once
// The conversation about a trace: a walk, and the commands that move it and look at it.

#include "visualizer/cli/options.hpp"
#include "visualizer/cli/quiz_game.hpp"
#include "visualizer/cli/step_text.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rayscope::cli {

/// What a command brought about.
struct Reply {
    bool ok = true;      ///< false: it could not be understood or done
    std::string command; ///< its full name; empty where none was understood
    std::string text;
};

/// What `find` found in the image.
struct Found {
    std::string condition;
    FindResult result;
};

class Session;

struct Command {
    std::string_view name;
    std::string_view aliases;  ///< with blanks between them; the first one is shown
    std::string_view argument; ///< as help shows it; empty: it takes none
    std::string_view help;
    std::string (Session::*perform)(const std::string& argument);
};

/// In the order of help.
[[nodiscard]] std::span<const Command> commands();

class Session {
public:
    /// `trace` is of a ray of `bench`; bench and style must outlive the session.
    /// @param choice how the trace was chosen: by a stage, or not
    Session(const Workbench& bench, Trace trace, const StepStyle& style, RayChoice choice = {})
        : bench_(bench), walk_(std::move(trace)), style_(style), choice_(std::move(choice)) {}

    /// The answer to one line; an empty one repeats the last command.
    [[nodiscard]] Reply reply(const std::string& line);
    [[nodiscard]] std::string answer(const std::string& line) { return reply(line).text; }

    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] bool quizzing() const { return quiz_.has_value(); }
    /// By the last `find`, if any pixel had it.
    [[nodiscard]] const std::optional<Found>& found() const { return found_; }
    [[nodiscard]] int current() const { return walk_.cursor().spot().ray; }
    [[nodiscard]] const Walk& walk() const { return walk_; }
    /// "ray 3 of 0-7, refracted, depth 1> ", or what a quiz asks for.
    [[nodiscard]] std::string prompt() const;
    /// What could stand in place of the last word of a line.
    [[nodiscard]] std::vector<std::string> completions(const std::string& line) const;

private:
    friend std::span<const Command> commands();

    // Moves: session_moves.cpp
    std::string next(const std::string& times);
    std::string back(const std::string& times);
    std::string step(const std::string& times);
    std::string step_back(const std::string& times);
    std::string in(const std::string& times);
    std::string back_into(const std::string& times);
    std::string over(const std::string& times);
    std::string back_over(const std::string& times);
    std::string out(const std::string& times);
    std::string back_out(const std::string& times);
    std::string go_on(const std::string& times);
    std::string go_back(const std::string& times);
    std::string go_to(const std::string& place);
    std::string undo(const std::string& times);
    std::string until(const std::string& condition);
    std::string pixel(const std::string& place);
    using Move = Moved (Cursor::*)();
    [[nodiscard]] std::string move(Move move, const char* name, const std::string& times);
    [[nodiscard]] std::string moved_text(Moved moved) const;
    [[nodiscard]] std::string place_text() const;

    // Looks: session_looks.cpp
    std::string tree(const std::string&);
    std::string path(const std::string&);
    std::string ray(const std::string& number);
    std::string event(const std::string&);
    std::string list(const std::string& count);
    std::string spans(const std::string& t);
    std::string light(const std::string&);
    std::string hit(const std::string&);
    std::string refraction(const std::string&);
    std::string cells(const std::string& stage);
    std::string why(const std::string& what);
    std::string colour(const std::string&);
    std::string energy(const std::string&);
    std::string print(const std::string& expression);
    std::string info(const std::string& topic);
    std::string help(const std::string& command);

    // Stops and questions: session_stops.cpp
    std::string set_break(const std::string& condition);
    std::string set_break_once(const std::string& condition);
    std::string set_watch(const std::string& expression);
    std::string remove(const std::string& numbers);
    std::string enable(const std::string& numbers);
    std::string disable(const std::string& numbers);
    std::string display(const std::string& expression);
    std::string undisplay(const std::string& numbers);
    std::string find(const std::string& condition);
    std::string compare(const std::string& what);
    std::string quiz(const std::string&);
    [[nodiscard]] Expression read_expression(const char* command, const std::string& text) const;
    [[nodiscard]] std::string stops_text() const;
    [[nodiscard]] std::string reasons_text() const;
    [[nodiscard]] std::string displays_text() const;

    // Files: session_files.cpp
    std::string png(const std::string& file);
    std::string save(const std::string& file);
    std::string source(const std::string& file);
    std::string quit(const std::string&);

    [[nodiscard]] const Trace& trace() const { return walk_.trace(); }
    [[nodiscard]] const Cursor& cursor() const { return walk_.cursor(); }

    struct Display {
        int number;
        Expression expression;
    };

    const Workbench& bench_;
    Walk walk_;
    const StepStyle& style_;
    RayChoice choice_;
    bool has_second_run_ = false;
    std::vector<Display> displays_;
    int last_display_ = 0, sources_ = 0;
    std::optional<QuizGame> quiz_;
    std::optional<Found> found_;
    std::string last_ = "next";
    bool ended_ = false;
};

} // namespace rayscope::cli
