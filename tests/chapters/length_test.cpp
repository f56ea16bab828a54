// A lesson is read in a quarter of an hour, with all that it shows.

#include "tests/chapters/pages.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace rayscope::test {
namespace {

/// About 215 words a minute, those of tables and of what programs print included.
constexpr int most_words = 3200;

int words_of(const std::string& text) {
    std::istringstream in(text);
    int count = 0;
    for (std::string word; in >> word;) ++count;
    return count;
}

TEST(Lessons, are_read_in_a_quarter_of_an_hour) {
    int lessons = 0;
    for (const std::string& page : lesson_pages()) {
        if (std::isdigit(static_cast<unsigned char>(page.substr(page.find('/') + 1).front())) == 0) continue;
        EXPECT_LE(words_of(page_text(page)), most_words) << page;
        ++lessons;
    }
    EXPECT_EQ(lessons, 8);
}

} // namespace
} // namespace rayscope::test
