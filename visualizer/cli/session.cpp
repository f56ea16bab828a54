// From a line to a command.

#include "visualizer/cli/session.hpp"

#include "visualizer/cli/failure.hpp"

#include <algorithm>
#include <string_view>

namespace rayscope::cli {
namespace {

constexpr std::size_t longest_command = 8000; // bytes

std::pair<std::string, std::string> first_word(const std::string& line) {
    const auto begin = line.find_first_not_of(" \t\r");
    if (begin == std::string::npos) return {};
    const auto end = line.find_first_of(" \t\r", begin);
    if (end == std::string::npos) return {line.substr(begin), ""};
    const auto rest = line.find_first_not_of(" \t\r", end);
    std::string argument = rest == std::string::npos ? "" : line.substr(rest);
    while (!argument.empty() &&
           (argument.back() == ' ' || argument.back() == '\t' || argument.back() == '\r'))
        argument.pop_back();
    return {line.substr(begin, end - begin), argument};
}

bool is_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

bool has_alias(const Command& command, std::string_view word) {
    for (std::size_t at = 0; at < command.aliases.size();) {
        const std::size_t end = std::min(command.aliases.find(' ', at), command.aliases.size());
        if (command.aliases.substr(at, end - at) == word) return true;
        at = end + 1;
    }
    return false;
}

/// By its name, by another of its names, or by the beginning of one name alone. Throws UsageError.
const Command& command_of(const std::string& word) {
    std::vector<const Command*> begun;
    for (const Command& command : commands()) {
        if (word == command.name || has_alias(command, word)) return command;
        if (command.name.starts_with(word)) begun.push_back(&command);
    }
    if (begun.size() == 1) return *begun.front();
    std::vector<std::string_view> names;
    for (const Command* command : begun) names.push_back(command->name);
    if (!names.empty()) throw UsageError(in_quotes(word) + " begins " + one_of(names));
    for (const Command& command : commands()) names.push_back(command.name);
    throw UsageError("unknown command " + in_quotes(word) + did_you_mean(word, names) + "; help lists them");
}

} // namespace

std::string Session::prompt() const {
    if (quiz_) return "your answer> ";
    const Spot spot = cursor().spot();
    const RaySpawned& start = trace().rays[std::size_t(spot.ray)].start();
    const std::string last = std::to_string(trace().rays.size() - 1);
    const std::string within =
        spot.event == 0 ? ""
                        : ", event " + std::to_string(spot.event) + " of " +
                              std::to_string(trace().rays[std::size_t(spot.ray)].events.size() - 1);
    return "ray " + std::to_string(spot.ray) + " of 0-" + last + ", " + name_of(start.kind) + ", depth " +
           std::to_string(start.depth) + within + "> ";
}

Reply Session::reply(const std::string& line) {
    Reply reply;
    try {
        if (line.size() > longest_command)
            throw UsageError("a line has at most " + std::to_string(longest_command) + " bytes");
        if (quiz_) {
            reply.command = "quiz";
            reply.text = quiz_->answer(line, walk_, style_); // what it can't read it asks again
            if (quiz_->ended()) quiz_.reset();
            return reply;
        }
        auto [word, argument] = first_word(line);
        if (word.empty()) std::tie(word, argument) = first_word(last_);
        if (is_number(word) && argument.empty()) {
            argument = word;
            word = "goto";
        }
        const Command& command = command_of(word);
        reply.command = command.name;
        if (!argument.empty() && command.argument.empty())
            throw UsageError(std::string(command.name) + " takes nothing after it");
        last_ = argument.empty() ? std::string(command.name) : std::string(command.name) + " " + argument;
        reply.text = (this->*command.perform)(argument);
    } catch (const UsageError& error) {
        reply.ok = false;
        reply.text += std::string(error.what()) + "\n";
    } catch (const std::runtime_error& error) { // of what it was to read, write or draw
        reply.ok = false;
        reply.text += std::string(error.what()) + "\n";
    }
    return reply;
}

std::vector<std::string> Session::completions(const std::string& line) const {
    const std::size_t begin = line.find_last_of(" \t") + 1;
    const std::string word = line.substr(begin), before = line.substr(0, begin);
    std::vector<std::string> known;
    const auto [first, rest] = first_word(before);
    if (first.empty()) {
        for (const Command& command : commands()) known.emplace_back(command.name);
    } else {
        const Command* command = nullptr;
        try {
            command = &command_of(first);
        } catch (const UsageError&) {
            return {};
        }
        const std::string_view takes = command->argument;
        if (takes.find("NAME") != std::string_view::npos || takes.find("CONDITION") != std::string_view::npos)
            known = vocabulary_of(bench_.scene).names(Target::object);
        if (takes.find("CONDITION") != std::string_view::npos ||
            takes.find("EXPRESSION") != std::string_view::npos)
            for (const auto& [name, field] : fields()) known.push_back(name);
        if (command->name == "info") known = {"breakpoints", "display", "scene", "fields"};
        if (command->name == "help")
            for (const Command& other : commands()) known.emplace_back(other.name);
    }
    std::erase_if(known, [&](const std::string& other) { return !other.starts_with(word); });
    return known;
}

} // namespace rayscope::cli
