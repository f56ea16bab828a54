// What each lesson.cpp prints is what its expected.txt holds, which a reader may have open beside it. Written anew by
//     RAYSCOPE_RENEW=yes build/release/bin/tests_chapters

#include "core/files/atomic_file.hpp"
#include "tests/chapters/pages.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace rayscope::test {
namespace {

/// "02_csg", …
std::vector<std::string> chapters_with_lessons() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(chapters_root / "chapters"))
        if (std::filesystem::exists(entry.path() / "lesson.cpp"))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

class Lesson : public testing::TestWithParam<std::string> {
protected:
    [[nodiscard]] static std::filesystem::path file(const char* name) {
        return chapters_root / "chapters" / GetParam() / name;
    }
};
INSTANTIATE_TEST_SUITE_P(, Lesson, testing::ValuesIn(chapters_with_lessons()),
                         [](const auto& chapter) { return chapter.param; });

TEST_P(Lesson, PrintsWhatIsExpected) {
    const Printed printed = printed_by("lesson " + GetParam().substr(GetParam().find('_') + 1));
    EXPECT_EQ(printed.code, 0);
    if (std::getenv("RAYSCOPE_RENEW") != nullptr) write_text_file(file("expected.txt"), printed.text);
    EXPECT_EQ(printed.text, content_of(file("expected.txt")));
}

TEST_P(Lesson, IsShort) { EXPECT_LE(lines_of_text(content_of(file("lesson.cpp"))).size(), 150U); }

TEST_P(Lesson, UsesOnlyCoresPublicFace) {
    for (const std::string& line : lines_of_text(content_of(file("lesson.cpp"))))
        EXPECT_TRUE(!line.starts_with("#include \"") || line == "#include \"core/rayscope.hpp\"") << line;
}

} // namespace
} // namespace rayscope::test
