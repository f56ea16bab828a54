// The README's commands exist, with their options and their scenes; its links lead somewhere.

#include "tests/support/shell.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;

const fs::path top = RAYSCOPE_SOURCE_DIR;

/// Without what a comment hides.
std::string shown_part(const std::string& page) {
    static const std::regex hidden(R"(<!--[^>]*-->)");
    return std::regex_replace(page, hidden, "");
}

/// What follows ./rayscope in indented lines and between backticks, without comments.
std::vector<std::string> readme_commands() {
    static const std::regex typed(R"((?:\n    |`)\./rayscope ([^`\n]*))"), comment(R"(\s+#.*$)");
    const std::string page = shown_part(content_of(top / "README.md"));
    std::vector<std::string> found;
    for (std::sregex_iterator it(page.begin(), page.end(), typed), end; it != end; ++it)
        found.push_back(std::regex_replace((*it)[1].str(), comment, ""));
    return found;
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

std::string help_of(const std::string& program) {
    const Printed help = printed_by_shell(program + " --help");
    EXPECT_EQ(help.code, 0) << program;
    return help.text;
}

std::set<std::string> scene_names() {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(top / "chapters"))
        if (entry.path().extension() == ".toml") names.insert(entry.path().stem().string());
    return names;
}

TEST(Readme, commands_exist_with_their_options_and_scenes) {
    const auto commands = readme_commands();
    ASSERT_GE(commands.size(), 25U) << "the commands were not found";
    const std::string launcher = content_of(top / "rayscope");
    const auto scenes = scene_names();
    std::map<std::string, std::string> help;
    for (const std::string& command : commands) {
        auto words = words_of(command);
        if (!words.empty() && words.front() == "--no-vtk") words.erase(words.begin());
        ASSERT_FALSE(words.empty());
        const std::string name = words.front();
        EXPECT_NE(launcher.find("\n    \"" + name + "|"), std::string::npos) << "./rayscope " << command;
        // Others' options are shown by the page of commands, which is compared with the programs.
        static const std::set<std::string> own = {"step",    "find",   "diff",    "trace",   "render",
                                                  "explain", "export", "extents", "accuracy"};
        if (!own.contains(name)) continue;
        std::string& text = help[name];
        if (text.empty()) text = help_of("'" RAYSCOPE_PROGRAM "' " + name);
        for (std::size_t i = 1; i < words.size(); ++i) {
            if (!words[i].starts_with("--") || words[i] == "--with")
                continue; // the exercises' program takes that one
            EXPECT_NE(text.find(words[i] + " "), std::string::npos)
                << "./rayscope " << command << ": " << words[i];
        }
        if (words.size() > 1 && !words[1].starts_with("-")) {
            EXPECT_TRUE(scenes.contains(words[1])) << "./rayscope " << command << ": " << words[1];
        }
    }
}

TEST(Readme, links_and_pictures_are_there) {
    static const std::regex link(R"(\]\(([^)#:]+)\))");
    for (const char* name : {"README.md", "CONTRIBUTING.md"}) {
        const std::string page = shown_part(content_of(top / name));
        int count = 0;
        for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it, ++count)
            EXPECT_TRUE(fs::exists(top / (*it)[1].str())) << name << ": " << (*it)[1];
        EXPECT_GT(count, 0) << name;
    }
}

TEST(Readme, is_short) {
    const std::string page = content_of(top / "README.md");
    EXPECT_LE(std::count(page.begin(), page.end(), '\n'), 150);
}

} // namespace
} // namespace rayscope::test
