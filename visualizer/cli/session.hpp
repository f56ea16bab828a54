#pragma once
// The conversation about a trace: where one is, and where one goes.

#include "visualizer/cli/step_text.hpp"

#include <vector>

namespace rayscope::cli {

class Session {
public:
    /// `trace` is of a ray of `bench`; all three must outlive the session.
    Session(const Workbench& bench, const Trace& trace, const StepStyle& style)
        : bench_(bench), trace_(trace), style_(style) {}

    /// Asks and answers on the terminal until quit or the end of input.
    void run();

    /// The answer to one line; an empty one repeats the last command.
    [[nodiscard]] std::string answer(const std::string& line);

    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] int current() const { return current_; }
    /// "ray 3 of 0-7, refracted, depth 1> "
    [[nodiscard]] std::string prompt() const;

private:
    [[nodiscard]] std::string perform(const std::string& command, const std::string& argument);
    [[nodiscard]] std::string go(int ray);
    [[nodiscard]] std::string next();
    [[nodiscard]] std::string in();
    [[nodiscard]] std::string over();
    [[nodiscard]] std::string out();
    [[nodiscard]] std::string back();
    [[nodiscard]] std::string go_to(const std::string& argument);
    [[nodiscard]] std::string why(const std::string& argument) const;
    [[nodiscard]] std::string compare(const std::string& argument) const;
    [[nodiscard]] std::string help() const;

    const Workbench& bench_;
    const Trace& trace_;
    const StepStyle& style_;
    int current_ = 0;
    std::vector<int> visited_; // before the current one, oldest first
    std::string last_ = "next";
    bool ended_ = false;
};

} // namespace rayscope::cli
