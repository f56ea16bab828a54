#include "tests/chapters/commands.hpp"

#include "tests/chapters/pages.hpp"

#include <set>

namespace rayscope::test {
namespace {

const std::string typed = "./rayscope ";

std::string without_comment(std::string text) {
    if (const auto comment = text.find(" # "); comment != std::string::npos) text.resize(comment);
    while (!text.empty() && text.back() == ' ') text.pop_back();
    return text;
}

bool stands_for_another(const std::string& text) {
    return text.find("…") != std::string::npos || text.find("NAME") != std::string::npos ||
           text.find("SCENE") != std::string::npos;
}

} // namespace

bool ShownCommand::has(const std::string& option) const {
    return (text + " ").find(" " + option + " ") != std::string::npos ||
           text.find(" " + option + "=") != std::string::npos;
}

std::vector<ShownCommand> commands_of(const std::string& page) {
    std::vector<ShownCommand> commands;
    const auto add = [&](int line, const std::string& text) {
        if (!text.empty() && !stands_for_another(text)) commands.push_back({line, text});
    };
    int number = 0;
    for (const std::string& line : lines_of_text(page_text(page))) {
        ++number;
        const std::size_t begin = line.find_first_not_of(' ');
        if (begin != std::string::npos && line.compare(begin, typed.size(), typed) == 0)
            add(number, without_comment(line.substr(begin + typed.size())));
        else if (const auto pipe = line.find("| " + typed); begin == 4 && pipe != std::string::npos)
            add(number, without_comment(line.substr(pipe + 2 + typed.size())));
        const std::string quoted = "`" + typed;
        for (std::size_t at = line.find(quoted); at != std::string::npos; at = line.find(quoted, at + 1)) {
            const std::size_t from = at + quoted.size();
            add(number, without_comment(line.substr(from, line.find('`', from) - from)));
        }
    }
    return commands;
}

Effort effort_of(const ShownCommand& command) {
    static const std::set<std::string> terminal = {"step",   "trace",   "find",   "diff",
                                                   "render", "explain", "export", "lesson"};
    static const std::set<std::string> slow = {"accuracy", "extents"};
    const std::string name = command.name();
    if (command.has("--with")) return Effort::elsewhere;
    if (slow.contains(name)) return Effort::long_or_vtk;
    if (!terminal.contains(name)) return Effort::elsewhere;
    const bool draws = command.has("--heat") || command.has("--png") || command.has("--cost") ||
                       command.text.find(".vtm") != std::string::npos;
    return draws ? Effort::long_or_vtk : Effort::at_once;
}

std::string made_small(const ShownCommand& command) {
    static const std::set<std::string> of_images = {"render", "find", "explain", "accuracy", "extents"};
    std::string text = command.text;
    if (command.name() == "step" && !command.has("--png") && !command.has("--no-png") &&
        !command.has("--compare"))
        text += " --no-png";
    if (!of_images.contains(command.name()) || command.has("--cases")) return text;
    if (const auto size = text.find(" --size "); size != std::string::npos)
        text.erase(size, text.find(' ', size + 8) - size);
    const bool without_size =
        command.name() == "explain" && !command.has("--cost") && !command.has("--energy");
    return without_size ? text : text + " --size 32x24";
}

} // namespace rayscope::test
