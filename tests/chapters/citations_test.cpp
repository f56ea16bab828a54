// Works that a lesson names by their title are listed in chapters/references.md, and each listed one is used.

#include "tests/chapters/pages.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <regex>

namespace rayscope::test {
namespace {

struct Work {
    std::string author, title;
    std::vector<std::string> files; ///< that the list says use it
};

std::string letters_of(const std::string& words) {
    std::string letters;
    for (const char c : words)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            letters += char(std::tolower(static_cast<unsigned char>(c)));
    return letters;
}

/// "- **Roth 1982**: S. D. Roth, *Ray Casting …*, … ([sweep.cpp](../core/csg/sweep.cpp))"
std::vector<Work> listed_works() {
    static const std::regex entry(R"(^- \*\*([^ ,*]+)[^*]*\*\*: [^*]+\*([^*]+)\*)"), link(R"(\]\(([^)#]+))");
    std::vector<Work> works;
    for (const std::string& line : lines_of_text(page_text("chapters/references.md"))) {
        std::smatch found;
        if (!std::regex_search(line, found, entry)) continue;
        Work work{found[1], found[2], {}};
        for (std::sregex_iterator at(line.begin(), line.end(), link), end; at != end; ++at)
            work.files.push_back((*at)[1]);
        works.push_back(std::move(work));
    }
    return works;
}

/// An initial that begins a sentence or a name comes first: "S. D. Roth, *Ray casting for modeling solids*".
std::vector<std::string> titles_named_in(const std::string& text) {
    static const std::regex named(R"((?:^|[.,;(] )[A-Z]\. [A-Z][^*\n.]+(?:\. [^*\n.]+)*, \*([^*\n]+)\*)");
    std::vector<std::string> titles;
    for (std::sregex_iterator at(text.begin(), text.end(), named), end; at != end; ++at)
        titles.push_back((*at)[1]);
    return titles;
}

TEST(Citations, of_lessons_are_listed) {
    const std::vector<Work> works = listed_works();
    std::size_t count = 0;
    for (const std::string& page : lesson_pages()) {
        if (page.ends_with("references.md")) continue;
        for (const std::string& title : titles_named_in(page_text(page))) {
            const bool listed = std::any_of(works.begin(), works.end(), [&](const Work& work) {
                return letters_of(work.title) == letters_of(title);
            });
            EXPECT_TRUE(listed) << page << " names '" << title
                                << "', which chapters/references.md does not list";
            ++count;
        }
    }
    EXPECT_GE(count, 7U);
}

TEST(Citations, that_are_listed_are_used) {
    const std::vector<Work> works = listed_works();
    EXPECT_GE(works.size(), 25U);
    for (const Work& work : works) {
        bool used = false;
        for (const std::string& file : work.files)
            used =
                used || content_of(chapters_root / "chapters" / file).find(work.author) != std::string::npos;
        for (const std::string& page : lesson_pages())
            used = used || (!page.ends_with("references.md") &&
                            page_text(page).find(work.author) != std::string::npos);
        EXPECT_TRUE(used) << work.author << ", '" << work.title << "', is listed and nowhere cited";
    }
}

} // namespace
} // namespace rayscope::test
