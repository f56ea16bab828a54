// Every command that a lesson shows does what it says: it is run, in an empty folder, and ends with exit code 0. What takes
// long or needs the program that draws is run by the suite for `--full`; of other programs' commands the launcher and the
// exercises must know the names.

#include "tests/chapters/commands.hpp"
#include "tests/chapters/pages.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <map>

namespace rayscope::test {
namespace {

/// The scenes are found in it as they are in the project's folder.
void need_exit_code_0(const std::string& page, const ShownCommand& command) {
    const TemporaryFolder folder;
    std::filesystem::create_directory_symlink(chapters_root / "chapters", folder.path() / "chapters");
    const std::string text = made_small(command);
    const Printed printed = printed_by(text, folder.path());
    EXPECT_EQ(printed.code, 0) << page << ":" << command.line << ": ./rayscope " << text << "\n"
                               << printed.text;
}

std::string page_title(const std::string& page) {
    std::string title = page.substr(std::string("chapters/").size());
    title.resize(title.find_last_of('.'));
    for (char& c : title)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return title;
}

class ShownCommands : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(, ShownCommands, testing::ValuesIn(lesson_pages()),
                         [](const auto& page) { return page_title(page.param); });

TEST_P(ShownCommands, Run) {
    for (const ShownCommand& command : commands_of(GetParam()))
        if (effort_of(command) == Effort::at_once) need_exit_code_0(GetParam(), command);
}

TEST_P(ShownCommands, HaveOptionsThatExist) {
    std::map<std::string, std::string> help;
    for (const ShownCommand& command : commands_of(GetParam())) {
        if (effort_of(command) != Effort::long_or_vtk) continue;
        std::string& text = help[command.name()];
        if (text.empty()) text = printed_by(command.name() + " --help").text;
        for (std::size_t at = command.text.find(" --"); at != std::string::npos;
             at = command.text.find(" --", at + 1)) {
            const std::string option =
                command.text.substr(at + 1, command.text.find_first_of(" =", at + 1) - at - 1);
            EXPECT_NE(text.find(option), std::string::npos)
                << GetParam() << ":" << command.line << ": " << command.name() << " has no " << option;
        }
    }
}

/// "sphere", "1-03" or "1-03-sphere".
bool is_exercise(const std::string& name) {
    for (const auto& entry : std::filesystem::directory_iterator(chapters_root / "exercises")) {
        const std::string folder = entry.path().filename().string();
        if (!std::filesystem::exists(entry.path() / "exercise.toml")) continue;
        if (folder == name || folder.substr(5) == name || folder.substr(0, 4) == name) return true;
    }
    return false;
}

TEST_P(ShownCommands, AreKnownToTheLauncher) {
    const std::string launcher = content_of(chapters_root / "rayscope");
    for (const ShownCommand& command : commands_of(GetParam())) {
        const std::string where = GetParam() + ":" + std::to_string(command.line) + ": ";
        const bool known = launcher.find("\n    \"" + command.name() + "|") != std::string::npos;
        EXPECT_TRUE(known) << where << command.name();
        const std::string check = "exercises check ", with = "--with ";
        if (command.text.starts_with(check)) {
            EXPECT_TRUE(is_exercise(command.text.substr(check.size()))) << where << command.text;
        }
        if (const auto at = command.text.find(with); at != std::string::npos) {
            const std::string name = command.text.substr(at + with.size());
            EXPECT_TRUE(is_exercise(name.substr(0, name.find(' ')))) << where << command.text;
        }
    }
}

class ShownCommandsFull : public ShownCommands {};
INSTANTIATE_TEST_SUITE_P(, ShownCommandsFull, testing::ValuesIn(lesson_pages()),
                         [](const auto& page) { return page_title(page.param); });

TEST_P(ShownCommandsFull, Run) {
    if (!std::filesystem::exists(built_program("rayscope-view"))) GTEST_SKIP() << "built without pictures";
    for (const ShownCommand& command : commands_of(GetParam()))
        if (effort_of(command) == Effort::long_or_vtk) need_exit_code_0(GetParam(), command);
}

} // namespace
} // namespace rayscope::test
