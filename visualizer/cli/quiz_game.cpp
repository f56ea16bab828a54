#include "visualizer/cli/quiz_game.hpp"

#include "visualizer/cli/event_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/ray_facts.hpp"

#include <algorithm>

namespace rayscope::cli {
namespace {

std::string without_blanks(std::string text) {
    const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
    while (!text.empty() && blank(text.back())) text.pop_back();
    while (!text.empty() && blank(text.front())) text.erase(text.begin());
    return text;
}

std::string lower(std::string text) {
    for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// What a person knows before the decision.
std::string known_text(const Trace& trace, const Question& question, const Numbers& number) {
    const TracedRay& ray = trace.rays[std::size_t(question.spot.ray)];
    const RaySpawned& start = ray.start();
    std::string text = ray_name(question.spot.ray) + ", " + name_of(start.kind) + ", from " +
                       number.vector(start.origin) + " towards " + number.vector(start.direction);
    const auto* hit = ray.find<BoundaryChosen>();
    if ((question.kind == Quiz::total || question.kind == Quiz::bend) && hit != nullptr) {
        const double theta = refraction_card(trace, question.spot.ray)->theta_from;
        text += "; it meets the boundary from " + medium_name(trace, hit->medium_from) +
                " (c₁ = " + number(hit->speed_from) + ") to " + medium_name(trace, hit->medium_to) +
                " (c₂ = " + number(hit->speed_to) + ") at θ₁ = " + number.degrees(theta);
    }
    return text + ".";
}

std::string asked_text(const Trace& trace, const Question& question, const Numbers& number) {
    switch (question.kind) {
    case Quiz::object: return "Which object does the ray end on?";
    case Quiz::inside:
        return "Is t = " + number(question.t) + " inside " + object_name(trace, question.object) + "?";
    case Quiz::total: return "Is reflection total here?";
    case Quiz::bend: return "Which way does the ray bend?";
    case Quiz::light:
        return "Is light " + light_name(trace, trace.rays[std::size_t(question.spot.ray)].start().light) +
               " seen from there?";
    }
    return "";
}

/// An index into the choices. Throws UsageError.
std::size_t choice_of(const Question& question, const std::string& text) {
    const std::string word = lower(text);
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        if (word == std::to_string(i + 1) || word == lower(question.choices[i])) return i;
    std::optional<std::size_t> begun;
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        if (lower(question.choices[i]).starts_with(word)) {
            if (begun) throw UsageError(in_quotes(text) + " begins several of the choices");
            begun = i;
        }
    if (begun) return *begun;
    throw UsageError("expected a number from 1 to " + std::to_string(question.choices.size()) +
                     ", the words of a choice, skip or quit, found " + in_quotes(text));
}

} // namespace

QuizGame::QuizGame(const Walk& walk, const std::vector<std::string>& names)
    : questions_(questions_of(walk.trace(), walk.timeline(), names)) {
    const auto first = std::ranges::find_if(questions_, [&](const Question& question) {
        return walk.timeline().moment(question.spot) > walk.cursor().moment();
    });
    questions_.erase(questions_.begin(), first);
    ended_ = questions_.empty();
}

std::string QuizGame::begin(const Walk& walk, const StepStyle& style) const {
    if (ended_) return "Nothing is left to ask from here on: goto start, and quiz again.\n";
    return "Predict each decision before it is shown: a number, or words; skip; quit.\n" +
           question_text(walk, style);
}

std::string QuizGame::question_text(const Walk& walk, const StepStyle& style) const {
    const Question& question = questions_[at_];
    Page page(style.paint);
    page.rule("question " + std::to_string(at_ + 1) + " of " + std::to_string(questions_.size()));
    page.line(known_text(walk.trace(), question, style.number), 2);
    page.line(style.paint.bold(asked_text(walk.trace(), question, style.number)), 2);
    for (std::size_t i = 0; i < question.choices.size(); ++i)
        page.line(std::to_string(i + 1) + std::string(glue) + glue + harmless(question.choices[i]), 4);
    return page.text();
}

std::string QuizGame::score_text() const {
    return "Score: " + std::to_string(right_) + " of " + std::to_string(answered_) + " right.\n";
}

std::string QuizGame::answer(const std::string& line, Walk& walk, const StepStyle& style) {
    const std::string text = without_blanks(line);
    if (text == "quit" || text == "q") {
        ended_ = true;
        return score_text();
    }
    const Question& question = questions_[at_];
    std::string reply;
    const std::string truth = harmless(question.choices[question.right]);
    if (text == "skip") {
        reply = "It is: " + truth + ".\n";
    } else {
        const bool right = choice_of(question, text) == question.right;
        ++answered_;
        right_ += right ? 1 : 0;
        reply = (right ? "✓ Right: " : "✗ No: ") + truth + ". " + score_text();
    }
    (void)walk.cursor().go_to(question.spot);
    reply += event_text(walk.here(), style, true);
    if (question.kind == Quiz::inside) {
        const auto spans = spans_after(walk.here().traced(), std::size_t(question.spot.event));
        for (int i = 1; std::size_t(i) <= spans.size(); ++i) {
            (void)walk.cursor().step();
            reply += event_text(walk.here(), style, false);
        }
    }
    if (++at_ == questions_.size()) {
        ended_ = true;
        return reply + "\nThat was the last question. " + score_text();
    }
    return reply + question_text(walk, style);
}

} // namespace rayscope::cli
