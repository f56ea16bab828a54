// What a page points at exists: files, headings, tests, exercises, figures.

#include "tests/chapters/pages.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <regex>
#include <set>

namespace rayscope::test {
namespace {

/// "What is outside?" is `what-is-outside`, as GitHub and pandoc have it: letters, digits, - and _ stay. (Headings that
/// are linked to hold no other letters than ASCII's.)
std::string anchor_of(const std::string& heading) {
    std::string anchor;
    for (const char c : heading) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == ' ')
            anchor += '-';
        else if (std::isalnum(byte) != 0 || c == '-' || c == '_')
            anchor += char(std::tolower(byte));
    }
    return anchor;
}

std::set<std::string> anchors_of(const std::string& text) {
    std::set<std::string> anchors;
    bool code = false;
    for (const std::string& line : lines_of_text(text)) {
        if (line.starts_with("```")) code = !code;
        if (!code && line.starts_with("#")) anchors.insert(anchor_of(line.substr(line.find(' ') + 1)));
    }
    return anchors;
}

/// The lessons, the reference, and the pages beside them that a reader begins with.
std::vector<std::string> all_pages() {
    std::vector<std::string> pages{"README.md", "CONTRIBUTING.md", "bench/README.md",
                                   "tests/oracle/README.md"};
    for (const char* folder : {"chapters", "exercises"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(chapters_root / folder))
            if (entry.path().extension() == ".md")
                pages.push_back(entry.path().lexically_relative(chapters_root).generic_string());
    return pages;
}

TEST(Links, lead_somewhere) {
    static const std::regex link(R"re(\]\(([^)#\s]*)(#([^)\s]+))?\))re");
    int count = 0;
    for (const std::string& page : all_pages()) {
        const std::string text = page_text(page);
        const auto folder = (chapters_root / page).parent_path();
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at, ++count) {
            const std::string target = (*at)[1], anchor = (*at)[3];
            if (target.starts_with("http")) continue;
            const auto path = target.empty() ? chapters_root / page : folder / target;
            EXPECT_TRUE(std::filesystem::exists(path)) << page << ": " << target;
            if (!anchor.empty() && std::filesystem::exists(path)) {
                EXPECT_TRUE(anchors_of(content_of(path)).contains(anchor))
                    << page << ": no heading '" << anchor << "' in "
                    << path.lexically_relative(chapters_root);
            }
        }
    }
    EXPECT_GT(count, 600);
}

std::vector<std::string> cells_of(const std::string& row) {
    std::vector<std::string> cells;
    for (std::size_t at = 0; (at = row.find("| ", at)) != std::string::npos;) {
        const std::size_t begin = at + 2, end = row.find(" |", begin);
        if (end == std::string::npos) break;
        cells.push_back(row.substr(begin, end - begin));
        at = end + 1;
    }
    return cells;
}

/// "csg.Holds.truth_table" is TEST(Holds, truth_table), or TEST_F or TEST_P, in tests/csg.
bool is_a_test(const std::string& name) {
    const std::size_t first = name.find('.'), second = name.find('.', first + 1);
    if (second == std::string::npos) return false;
    const auto folder = chapters_root / "tests" / name.substr(0, first);
    if (!std::filesystem::exists(folder)) return false;
    const std::string words =
        "(" + name.substr(first + 1, second - first - 1) + ", " + name.substr(second + 1) + ")";
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".cpp" && content_of(entry.path()).find(words) != std::string::npos)
            return true;
    return false;
}

bool is_a_figure(const std::string& name) {
    for (const auto& entry : std::filesystem::directory_iterator(chapters_root / "chapters"))
        if (std::filesystem::exists(entry.path() / "figures" / (name + ".svg"))) return true;
    return false;
}

TEST(Coverage, names_tests_exercises_and_figures_that_exist) {
    int rows = 0;
    for (const std::string& line : lines_of_text(page_text("chapters/README.md"))) {
        const std::vector<std::string> cells = cells_of(line);
        if (cells.size() != 6 || cells[3].find('`') != 0) continue;
        EXPECT_TRUE(is_a_test(cells[3].substr(1, cells[3].size() - 2))) << line;
        EXPECT_TRUE(std::filesystem::exists(chapters_root / "exercises" / cells[4] / "exercise.toml"))
            << line;
        EXPECT_TRUE(is_a_figure(cells[5])) << line;
        ++rows;
    }
    EXPECT_GT(rows, 75);
}

/// Each row of the table at the top of the errata has its section, with a command and a test that exists.
TEST(Errata, have_a_ray_and_a_test_each) {
    const std::string text = page_text("chapters/errata.md");
    static const std::regex section(R"re(\n### [^\n]+\n)re"), named(R"re(`(errata\.[A-Za-z_.]+)`)re");
    std::vector<std::size_t> starts;
    for (std::sregex_iterator at(text.begin(), text.end(), section), end; at != end; ++at)
        starts.push_back(std::size_t(at->position()));
    EXPECT_EQ(starts.size(), 14U);
    starts.push_back(text.size());
    for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
        const std::string part = text.substr(starts[i], starts[i + 1] - starts[i]);
        EXPECT_NE(part.find("\n    ./rayscope "), std::string::npos) << part;
        EXPECT_NE(part.find("Lesson: ["), std::string::npos) << part;
        std::sregex_iterator at(part.begin(), part.end(), named), end;
        EXPECT_NE(at, end) << part;
        for (; at != end; ++at) EXPECT_TRUE(is_a_test((*at)[1])) << (*at)[1];
    }
}

} // namespace
} // namespace rayscope::test
