// The figures that are kept with the lessons are the ones that the program draws.

#include "tests/support/temporary_folder.hpp"
#include "visualizer/figures/catalogue.hpp"

#include <gtest/gtest.h>

namespace rayscope::figures {
namespace {

namespace fs = std::filesystem;

const fs::path chapters = fs::path(RAYSCOPE_SOURCE_DIR) / "chapters";

/// Without the pictures in it, whose last bits are the graphics library's.
std::string vectors_of(std::string svg) {
    constexpr std::string_view begin = "base64,";
    for (auto at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at + begin.size()))
        svg.erase(at + begin.size(), svg.find('"', at) - at - begin.size());
    return svg;
}

bool has_picture(const std::string& svg) { return svg.find("base64,") != std::string::npos; }

void compare(bool with_picture) {
    for (const Entry& entry : read_catalogue()) {
        const std::string kept = test::content_of(chapters / entry.file());
        if (has_picture(kept) != with_picture) continue;
        EXPECT_EQ(vectors_of(drawn(entry, chapters)), vectors_of(kept))
            << entry.name << ": ./rayscope figures --only " << entry.name << " draws it anew";
    }
}

TEST(Committed, FiguresOfLinesAreDrawnAgainAlike) { compare(false); }
TEST(CommittedFull, FiguresWithPicturesAreDrawnAgainAlike) { compare(true); }

TEST(Committed, AreSmallAndSayWhatTheyShow) {
    for (const Entry& entry : read_catalogue()) {
        const std::string kept = test::content_of(chapters / entry.file());
        EXPECT_GT(kept.size(), 500U) << entry.name;
        EXPECT_LE(kept.size(), 250'000U) << entry.name;
        EXPECT_NE(kept.find("<title>"), std::string::npos) << entry.name;
        EXPECT_NE(kept.find("<desc>"), std::string::npos) << entry.name;
    }
}

TEST(Committed, LessonsShowFiguresWithTheirWords) {
    for (const Entry& entry : read_catalogue()) {
        const std::string lesson = test::content_of(chapters / entry.chapter / "README.md");
        EXPECT_NE(lesson.find("![" + entry.alt + "](figures/" + entry.name + ".svg)"), std::string::npos)
            << entry.name;
    }
}

} // namespace
} // namespace rayscope::figures
