// chapters/reference/commands.md is what the programs say of themselves. It is written anew by
//     RAYSCOPE_RENEW=yes build/release/bin/tests_reference

#include "core/files/atomic_file.hpp"
#include "tests/support/shell.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <sstream>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;

const fs::path checkout = RAYSCOPE_SOURCE_DIR;
const fs::path page_file = checkout / "chapters/reference/commands.md";

struct Command {
    std::string name, target, summary;
};

/// The launcher's table.
std::vector<Command> commands() {
    static const std::regex line(R"re(\n    "([a-z]+)\|([^|"]*)\|([^"]*)")re");
    const std::string launcher = content_of(checkout / "rayscope");
    std::vector<Command> found;
    for (std::sregex_iterator it(launcher.begin(), launcher.end(), line), end; it != end; ++it)
        found.push_back({(*it)[1], (*it)[2], (*it)[3]});
    return found;
}

std::string quoted(const fs::path& path) { return "'" + path.string() + "'"; }

/// What answers `--help` for a command that is no word of rayscope itself. The launcher builds nothing for these lines.
std::string program_of(const Command& command) {
    const fs::path programs = fs::path(RAYSCOPE_PROGRAM).parent_path();
    if (command.name == "exercises" || command.name == "bench" || command.name == "figures")
        return quoted(programs / ("rayscope-" + command.name));
    if (command.name == "book")
        return "COLUMNS=100 python3 -B " + quoted(checkout / "chapters/book/build.py");
    if (command.name == "lesson") return "bash " + quoted(checkout / "rayscope") + " lesson";
    return quoted(RAYSCOPE_PROGRAM) + " " + command.name;
}

std::string printed_help(const std::string& program) {
    const std::string line = "cd " + quoted(checkout) + " && " + program + " --help";
    auto [code, text] = printed_by_shell(line);
    EXPECT_EQ(code, 0) << line << "\n" << text;
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return text.substr(std::min(text.find_first_not_of('\n'), text.size())) + "\n";
}

std::vector<std::string> subcommands_in(const std::string& help) {
    std::vector<std::string> names;
    std::istringstream lines(help.substr(std::min(help.find("Subcommands:\n"), help.size())));
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line) && line.starts_with("  ")) {
        const auto end = line.find(' ', 2);
        if (end != 2) names.push_back(line.substr(2, end - 2));
    }
    return names;
}

std::string block(const std::string& text) { return "```text\n" + text + "```\n\n"; }

std::string section(const Command& command) {
    std::string text = "## " + command.name + "\n\n";
    if (command.target.empty())
        return text + "`./rayscope " + command.name + "`: " + command.summary + ".\n\n";
    const std::string program = program_of(command), help = printed_help(program);
    text += block(help);
    for (const std::string& name : subcommands_in(help))
        text += "### " + command.name + " " + name + "\n\n" + block(printed_help(program + " " + name));
    return text;
}

std::string whole_page() {
    std::string text =
        "# Commands\n\n"
        "What each command says of itself with `./rayscope help COMMAND`. `rayscope` in these texts is "
        "`./rayscope` in a checkout. A test compares this page with the programs; do not edit it by "
        "hand, but run `RAYSCOPE_RENEW=yes build/release/bin/tests_reference`.\n\n"
        "What one types once the stepper runs is told in [the debugger for rays](debugger.md).\n\n"
        "| command | |\n| --- | --- |\n";
    for (const Command& command : commands())
        text += "| [" + command.name + "](#" + command.name + ") | " +
                std::regex_replace(command.summary, std::regex(R"(\|)"), R"(\|)") + " |\n";
    text += "\n";
    for (const Command& command : commands()) text += section(command);
    while (text.ends_with("\n\n")) text.pop_back();
    return text;
}

std::string first_difference_of(const std::string& was, const std::string& is) {
    std::istringstream old(was), now(is);
    std::string a, b;
    for (int line = 1;; ++line) {
        const bool more_a = bool(std::getline(old, a)), more_b = bool(std::getline(now, b));
        if (!more_a && !more_b) return "";
        if (a != b || more_a != more_b)
            return "line " + std::to_string(line) + "\nshown: " + (more_a ? a : "(the end)") +
                   "\nis:    " + (more_b ? b : "(the end)");
    }
}

TEST(Commands, are_shown_as_the_programs_print_them) {
    ASSERT_GE(commands().size(), 12U) << "the launcher's table could not be read";
    for (const char* program :
         {"rayscope-exercises", "rayscope-bench", "rayscope-figures", "rayscope-window"})
        if (!fs::exists(fs::path(RAYSCOPE_PROGRAM).parent_path() / program))
            GTEST_SKIP() << program << " is not built";
    if (std::system("python3 --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "python3 is missing";
    const std::string is = whole_page();
    if (std::getenv("RAYSCOPE_RENEW") != nullptr) write_text_file(page_file, is);
    const std::string was = content_of(page_file);
    EXPECT_TRUE(was == is) << page_file.string() << ", " << first_difference_of(was, is)
                           << "\nwrite it anew with: RAYSCOPE_RENEW=yes build/release/bin/tests_reference";
}

} // namespace
} // namespace rayscope::test
