#include "visualizer/cli/session.hpp"

#include "visualizer/cli/compare_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/line_input.hpp"
#include "visualizer/cli/why_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string_view>

namespace rayscope::cli {
namespace {

struct Command {
    std::string_view name, letter, help;
};

constexpr std::array<Command, 13> commands{{
    {"next", "n", "the next ray, in the order of spawning"},
    {"in", "i", "the first ray that this one spawned"},
    {"over", "o", "the next ray that the same parent spawned; after the last one: out"},
    {"out", "u", "up to the parent"},
    {"back", "b", "where you were before"},
    {"goto", "g", "goto N: ray N of the tree; N alone does the same"},
    {"tree", "t", "the recursion, this ray marked"},
    {"ray", "r", "this ray again"},
    {"why", "y", "why NAME: why this ray did not end on the drawn object of that name"},
    {"compare", "m",
     "compare LIST: where the first ray with other numbers, such as float,textbook, parts from this run"},
    {"colour", "c", "the colour of the whole, and where it comes from"},
    {"help", "h", "this list"},
    {"quit", "q", "end (or Ctrl-D)"},
}};

const Command* command_of(const std::string& word) {
    const auto* const found = std::find_if(commands.begin(), commands.end(), [&](const Command& command) {
        return word == command.name || word == command.letter || (word == "?" && command.name == "help");
    });
    return found == commands.end() ? nullptr : found;
}

std::pair<std::string, std::string> first_word(const std::string& line) {
    const auto begin = line.find_first_not_of(" \t");
    if (begin == std::string::npos) return {};
    const auto end = line.find_first_of(" \t", begin);
    if (end == std::string::npos) return {line.substr(begin), ""};
    const auto rest = line.find_first_not_of(" \t", end);
    std::string argument = rest == std::string::npos ? "" : line.substr(rest);
    while (!argument.empty() && (argument.back() == ' ' || argument.back() == '\t')) argument.pop_back();
    return {line.substr(begin, end - begin), argument};
}

bool is_number(const std::string& text) {
    return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

} // namespace

void Session::run() {
    LineInput input;
    std::fputs("\nnext, in, over, out, back, goto N, tree, ray, why NAME, compare LIST, colour, help, quit\n",
               stdout);
    while (!ended_) {
        std::fputs("\n", stdout);
        const auto line = input.read(prompt());
        if (!line) {
            std::fputs("\n", stdout);
            break;
        }
        std::fputs(answer(*line).c_str(), stdout);
    }
}

std::string Session::prompt() const {
    const RaySpawned& start = trace_.rays[std::size_t(current_)].start();
    const std::string last = std::to_string(trace_.rays.size() - 1);
    return "ray " + std::to_string(current_) + " of 0-" + last + ", " + name_of(start.kind) + ", depth " +
           std::to_string(start.depth) + "> ";
}

std::string Session::answer(const std::string& line) {
    auto [word, argument] = first_word(line);
    if (word.empty()) std::tie(word, argument) = first_word(last_);
    if (is_number(word) && argument.empty()) {
        argument = word;
        word = "goto";
    }
    const Command* command = command_of(word);
    if (command == nullptr) {
        std::vector<std::string_view> names;
        for (const Command& known : commands) names.push_back(known.name);
        return "unknown command " + in_quotes(word) + did_you_mean(word, names) + "; help lists them\n";
    }
    if (!argument.empty() && command->name != "goto" && command->name != "why" && command->name != "compare")
        return std::string(command->name) + " takes nothing after it\n";
    last_ = argument.empty() ? std::string(command->name) : std::string(command->name) + " " + argument;
    return perform(std::string(command->name), argument);
}

std::string Session::perform(const std::string& command, const std::string& argument) {
    if (command == "next") return next();
    if (command == "in") return in();
    if (command == "over") return over();
    if (command == "out") return out();
    if (command == "back") return back();
    if (command == "goto") return go_to(argument);
    if (command == "tree") return tree_text(trace_, style_, current_);
    if (command == "ray") return ray_text(trace_, current_, style_);
    if (command == "colour") return result_text(trace_, style_);
    if (command == "why") return why(argument);
    if (command == "compare") return compare(argument);
    if (command == "help") return help();
    ended_ = true;
    return "";
}

std::string Session::go(int ray) {
    visited_.push_back(current_);
    current_ = ray;
    return ray_text(trace_, current_, style_);
}

std::string Session::next() {
    if (std::size_t(current_) + 1 < trace_.rays.size()) return go(current_ + 1);
    return "That was the last ray: colour sums up, goto 0 starts again.\n";
}

std::string Session::in() {
    const auto& children = trace_.rays[std::size_t(current_)].children;
    return children.empty() ? "This ray spawned none: next or over go on.\n" : go(children.front());
}

std::string Session::over() {
    const int parent = trace_.rays[std::size_t(current_)].parent;
    if (parent == none) return "The first ray has no sibling: in goes to the rays that it spawned.\n";
    const auto& siblings = trace_.rays[std::size_t(parent)].children;
    const auto after = std::upper_bound(siblings.begin(), siblings.end(), current_);
    return after == siblings.end() ? out() : go(*after);
}

std::string Session::out() {
    const int parent = trace_.rays[std::size_t(current_)].parent;
    return parent == none ? "This is the first ray: nothing spawned it.\n" : go(parent);
}

std::string Session::back() {
    if (visited_.empty()) return "This is where you began.\n";
    current_ = visited_.back();
    visited_.pop_back();
    return ray_text(trace_, current_, style_);
}

std::string Session::go_to(const std::string& argument) {
    std::size_t ray = 0;
    const auto [end, error] = std::from_chars(argument.data(), argument.data() + argument.size(), ray);
    const bool whole = end == argument.data() + argument.size() && !argument.empty();
    if (error != std::errc{} || !whole || ray >= trace_.rays.size())
        return "goto: expected a ray from 0 to " + std::to_string(trace_.rays.size() - 1) + ", found " +
               in_quotes(argument) + "\n";
    return go(int(ray));
}

std::string Session::why(const std::string& argument) const {
    try {
        Page page(style_.paint);
        page.line(why_text(bench_, trace_, current_, find_drawn(bench_.scene, argument), style_.number));
        return page.text();
    } catch (const UsageError& error) {
        return "why: " + std::string(error.what()) + "\n";
    }
}

std::string Session::compare(const std::string& argument) const {
    try {
        const Configuration other =
            chosen_configuration("compare", argument, own_configuration(bench_.scene));
        return compare_text(bench_, trace_, other, style_);
    } catch (const UsageError& error) {
        return std::string(error.what()) + "\n";
    }
}

std::string Session::help() const {
    Page page(style_.paint);
    for (const Command& command : commands)
        page.item(std::string(command.name) + ", " + std::string(command.letter), std::string(command.help));
    page.line("An empty line repeats the last command.", 2);
    return page.text();
}

} // namespace rayscope::cli
