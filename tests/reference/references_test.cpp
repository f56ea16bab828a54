// Who is cited in a comment of the code, or in a chapter, stands in chapters/references.md.

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;

const fs::path tree = RAYSCOPE_SOURCE_DIR;

struct Citation {
    std::string author, year, where;
};

/// "Roth 1982", "Wald (2007)", "Jeannerod, Louvet, Muller 2013", "Haines et al. 2019": the name before the year.
std::vector<Citation> citations_in(const std::string& text, const std::string& where) {
    static const std::regex pattern(
        R"(([A-Z](?![A-Z])[^ ,.;:()0-9\n"'*`]+)(?:,? et al\.)?,?'?s? ?(?:approximation )?\(?((?:19|20)[0-9][0-9])\b)");
    static const std::set<std::string> not_people = {"January",  "February", "March",  "April",     "May",
                                                     "June",     "July",     "August", "September", "October",
                                                     "November", "December", "Gems",   "The"};
    std::vector<Citation> found;
    for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
        if (!not_people.contains((*it)[1])) found.push_back({(*it)[1], (*it)[2], where});
    return found;
}

std::vector<Citation> all_citations() {
    std::vector<Citation> found;
    for (const char* folder : {"core", "visualizer", "exercises", "bench", "chapters"})
        for (const auto& entry : fs::recursive_directory_iterator(tree / folder)) {
            const fs::path& path = entry.path();
            const std::string kind = path.extension().string(), name = path.filename().string();
            const bool read = kind == ".hpp" || kind == ".cpp" || kind == ".inl" || kind == ".md";
            if (!entry.is_regular_file() || !read || name == "references.md") continue;
            for (Citation& citation : citations_in(content_of(path), path.lexically_relative(tree).string()))
                found.push_back(std::move(citation));
        }
    return found;
}

/// A line of the list begins with the authors and the year in bold.
bool lists(const std::string& page, const Citation& citation) {
    for (std::size_t at = page.find("- **"); at != std::string::npos; at = page.find("- **", at + 4)) {
        const std::string heading = page.substr(at, page.find("**", at + 4) - at);
        if (heading.find(citation.author) != std::string::npos &&
            heading.find(citation.year) != std::string::npos)
            return true;
    }
    return false;
}

TEST(References, know_everybody_who_is_cited) {
    const std::string page = content_of(tree / "chapters/references.md");
    const auto cited = all_citations();
    EXPECT_GE(cited.size(), 15U) << "the citations were not found";
    for (const Citation& citation : cited)
        EXPECT_TRUE(lists(page, citation)) << citation.where << " cites " << citation.author << " "
                                           << citation.year << ", which chapters/references.md does not list";
}

TEST(References, reader_finds_names_and_years) {
    const auto found = citations_in(
        "loses digits (Haines, Akenine-Möller 2019); Schlick's approximation (1994), Wald 2007", "");
    ASSERT_EQ(found.size(), 3U);
    EXPECT_EQ(found[0].year, "2019");
    EXPECT_EQ(found[1].author, "Schlick");
    EXPECT_EQ(found[2].author, "Wald");
}

TEST(References, name_files_that_are_there) {
    static const std::regex link(R"(\]\(([^)#:]+)\))");
    for (const char* name : {"references.md", "glossary.md"}) {
        const std::string page = content_of(tree / "chapters" / name);
        for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it)
            EXPECT_TRUE(fs::exists(tree / "chapters" / std::string((*it)[1]))) << name << ": " << (*it)[1];
    }
}

} // namespace
} // namespace rayscope::test
