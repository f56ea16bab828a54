// A block of code in a lesson is a part of a file: after <!-- code: PATH --> stands a block whose lines stand in that
// file one below the other, however far they are indented. A block of C++ without such a mark is an error.

#include "tests/chapters/pages.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

std::string unindented(const std::string& line) {
    const std::size_t begin = line.find_first_not_of(' ');
    return begin == std::string::npos ? "" : line.substr(begin);
}

bool stands_in(const std::vector<std::string>& block, const std::vector<std::string>& file) {
    for (std::size_t at = 0; at + block.size() <= file.size(); ++at) {
        std::size_t same = 0;
        while (same < block.size() && unindented(block[same]) == unindented(file[at + same])) ++same;
        if (same == block.size()) return true;
    }
    return false;
}

TEST(CodeInLessons, StandsInItsFile) {
    const std::string mark = "<!-- code: ", end_of_mark = " -->";
    int count = 0;
    for (const std::string& page : lesson_pages()) {
        const std::vector<std::string> lines = lines_of_text(page_text(page));
        std::string source;
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (lines[i].starts_with(mark))
                source = lines[i].substr(mark.size(), lines[i].size() - mark.size() - end_of_mark.size());
            if (lines[i] != "```cpp") continue;
            std::vector<std::string> block;
            while (++i < lines.size() && lines[i] != "```") block.push_back(lines[i]);
            EXPECT_FALSE(source.empty()) << page << ":" << i + 1 << ": from which file is this?";
            EXPECT_TRUE(stands_in(block, lines_of_text(content_of(chapters_root / source))))
                << page << ":" << i + 1 << ": not in " << source << " (any more):\n"
                << (block.empty() ? "" : block.front());
            source.clear();
            ++count;
        }
    }
    EXPECT_GE(count, 1);
}

} // namespace
} // namespace rayscope::test
