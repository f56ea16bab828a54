// What a chapter shows of the program is what the program says.
//
// Between <!-- shown: step SCENE … --> and <!-- end --> stands, as a block of code, what that command prints; between
// <!-- shown: cases --> and <!-- end --> the digest of the oracle's cases. Both are written anew by
//     RAYSCOPE_RENEW=yes build/release/bin/tests_chapters

#include "core/cases/score_report.hpp"
#include "core/files/atomic_file.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace rayscope::test {
namespace {

const std::filesystem::path source_tree = RAYSCOPE_SOURCE_DIR;
const std::string opening = "<!-- shown: ", opened = " -->\n", closing = "<!-- end -->";

std::string printed_by(const std::string& arguments) {
    const std::string command =
        "cd '" + source_tree.string() + "' && '" RAYSCOPE_PROGRAM "' " + arguments + " 2>&1 </dev/null";
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return "could not run " + command;
    std::string text;
    std::array<char, 4096> bytes{};
    while (const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), pipe))
        text.append(bytes.data(), count);
    EXPECT_EQ(pclose(pipe), 0) << command << "\n" << text;
    return text;
}

std::string shown(const std::string& what) {
    if (what == "cases") return "\n" + scores_digest(score_folder(source_tree / "tests/oracle/cases")) + "\n";
    return "\n```text\n$ ./rayscope " + what + "\n" + printed_by(what) + "```\n\n";
}

/// The page with everything that it shows written anew.
std::string renewed(const std::string& page, int& count) {
    std::string text;
    std::size_t at = 0;
    for (std::size_t begin = page.find(opening); begin != std::string::npos; begin = page.find(opening, at)) {
        const std::size_t what = begin + opening.size(), old = page.find(opened, what);
        const std::size_t end = page.find(closing, old);
        if (old == std::string::npos || end == std::string::npos) {
            ADD_FAILURE() << "unfinished: " << page.substr(begin, 60);
            break;
        }
        text += page.substr(at, old + opened.size() - at) + shown(page.substr(what, old - what));
        at = end;
        ++count;
    }
    return text + page.substr(at);
}

std::string first_difference(const std::string& was, const std::string& is) {
    const auto line_at = [](const std::string& text, std::size_t at) {
        const std::size_t begin = text.rfind('\n', at) + 1;
        return text.substr(begin, text.find('\n', at) - begin);
    };
    std::size_t at = 0;
    while (at < was.size() && at < is.size() && was[at] == is[at]) ++at;
    at = std::min({at, was.size() - 1, is.size() - 1});
    return "shown: " + line_at(was, at) + "\nis:    " + line_at(is, at);
}

TEST(ShownText, IsWhatTheProgramSays) {
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(source_tree / "chapters")) {
        if (entry.path().extension() != ".md") continue;
        const std::string was = content_of(entry.path()), is = renewed(was, count);
        if (std::getenv("RAYSCOPE_RENEW") != nullptr)
            write_text_file(entry.path(), is);
        else
            EXPECT_TRUE(was == is)
                << entry.path().string() << " shows what is no longer true\n"
                << first_difference(was, is)
                << "\nwrite it anew with: RAYSCOPE_RENEW=yes build/release/bin/tests_chapters";
    }
    EXPECT_GE(count, 2); // the table and the example of chapter 7
}

} // namespace
} // namespace rayscope::test
