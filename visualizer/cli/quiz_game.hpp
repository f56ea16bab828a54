#pragma once
// Predict, then reveal, as a conversation with a score.

#include "visualizer/cli/step_text.hpp"

namespace rayscope::cli {

class QuizGame {
public:
    /// @param names of all drawn objects
    QuizGame(const Walk& walk, const std::vector<std::string>& names);

    /// What is asked first.
    [[nodiscard]] std::string begin(const Walk& walk, const StepStyle& style) const;
    /// Takes an answer: a choice's number or words, "skip", or "quit". Shows the truth, moves the walk there, and asks
    /// the next question, or tells the score.
    [[nodiscard]] std::string answer(const std::string& line, Walk& walk, const StepStyle& style);
    [[nodiscard]] bool ended() const { return ended_; }

private:
    [[nodiscard]] std::string question_text(const Walk& walk, const StepStyle& style) const;
    [[nodiscard]] std::string score_text() const;

    std::vector<Question> questions_;
    std::size_t at_ = 0;
    int right_ = 0, answered_ = 0;
    bool ended_ = false;
};

} // namespace rayscope::cli
