// What a chapter shows of the program is what the program says.
//
// Between <!-- shown: step SCENE … --> and <!-- end --> stands, as a block of code, what that command prints;
// <!-- shown: step SCENE … | ray 4, / Refraction | Hit --> shows only paragraphs of it: the first one after a line that
// begins with "ray 4," whose first line begins with "Refraction", and the first one that begins with "Hit". Between
// <!-- shown: cases --> and <!-- end --> stands the digest of the oracle's cases. All are written anew by
//     RAYSCOPE_RENEW=yes build/release/bin/tests_chapters

#include "core/cases/score_report.hpp"
#include "core/files/atomic_file.hpp"
#include "tests/chapters/pages.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace rayscope::test {
namespace {

const std::string opening = "<!-- shown: ", opened = " -->\n", closing = "<!-- end -->";

std::vector<std::string> parts_of(const std::string& text, const std::string& separator) {
    std::vector<std::string> parts;
    std::size_t at = 0;
    for (std::size_t end = 0; end != std::string::npos; at = end + separator.size()) {
        end = text.find(separator, at);
        parts.push_back(text.substr(at, end - at));
    }
    return parts;
}

/// "── ray 4, refracted ──" begins with "ray 4,".
bool begins_with(std::string_view line, std::string_view words) {
    for (const std::string_view ornament : {"─", " "})
        while (line.starts_with(ornament)) line.remove_prefix(ornament.size());
    return line.starts_with(words);
}

/// A paragraph: from the line that the path leads to, up to the next empty one.
std::string section_of(const std::vector<std::string>& lines, const std::string& path) {
    std::size_t at = 0;
    for (const std::string& words : parts_of(path, " / ")) {
        while (at < lines.size() && !begins_with(lines[at], words)) ++at;
        if (at == lines.size()) {
            ADD_FAILURE() << "nothing that was printed begins with '" << words << "' (of '" << path << "')";
            return {};
        }
    }
    std::string section;
    for (; at < lines.size() && !lines[at].empty(); ++at) section += lines[at] + "\n";
    return section;
}

std::string run(const std::string& arguments) {
    const Printed printed = printed_by(arguments);
    EXPECT_EQ(printed.code, 0) << arguments << "\n" << printed.text;
    return printed.text;
}

std::string shown(const std::string& what) {
    if (what == "cases")
        return "\n" + scores_digest(score_folder(chapters_root / "tests/oracle/cases")) + "\n";
    const std::vector<std::string> parts = parts_of(what, " | ");
    const std::string head = "\n```text\n$ ./rayscope " + parts[0] + "\n", tail = "```\n\n";
    if (parts.size() == 1) return head + run(what) + tail;
    // No picture: it is not what the paragraphs show, and takes longer than all the rest.
    const bool draws = parts[0].starts_with("step ") && parts[0].find("--no-png") == std::string::npos &&
                       parts[0].find("--compare") == std::string::npos;
    const std::vector<std::string> lines = lines_of_text(run(parts[0] + (draws ? " --no-png" : "")));
    std::string text = head;
    for (std::size_t i = 1; i < parts.size(); ++i) text += "…\n" + section_of(lines, parts[i]);
    return text + tail;
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

std::string title_of(const std::filesystem::path& page) {
    std::string title =
        page.lexically_relative(chapters_root / "chapters").replace_extension().generic_string();
    for (char& c : title)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
    return title;
}

std::vector<std::filesystem::path> pages_that_show() {
    std::vector<std::filesystem::path> pages;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(chapters_root / "chapters"))
        if (entry.path().extension() == ".md" && content_of(entry.path()).find(opening) != std::string::npos)
            pages.push_back(entry.path());
    std::sort(pages.begin(), pages.end());
    return pages;
}

class ShownText : public testing::TestWithParam<std::filesystem::path> {};
INSTANTIATE_TEST_SUITE_P(, ShownText, testing::ValuesIn(pages_that_show()),
                         [](const auto& page) { return title_of(page.param); });

TEST_P(ShownText, IsWhatTheProgramSays) {
    int count = 0;
    const std::string was = content_of(GetParam()), is = renewed(was, count);
    EXPECT_GE(count, 1);
    if (std::getenv("RAYSCOPE_RENEW") != nullptr)
        write_text_file(GetParam(), is);
    else
        EXPECT_TRUE(was == is) << GetParam().string() << " shows what is no longer true\n"
                               << first_difference(was, is)
                               << "\nwrite it anew with: RAYSCOPE_RENEW=yes build/release/bin/tests_chapters";
}

} // namespace
} // namespace rayscope::test
