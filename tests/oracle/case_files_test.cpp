// No case is lost on the way: files, counts, kinds.

#include "tests/oracle/case_files.hpp"
#include "tests/oracle/cavity_checks.hpp"
#include "tests/oracle/grid_checks.hpp"
#include "tests/oracle/line_checks.hpp"
#include "tests/oracle/refraction_checks.hpp"
#include "tests/oracle/triangle_checks.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

namespace rayscope::test {
namespace {

struct Count {
    std::string kind;
    std::size_t cases = 0;

    friend bool operator==(const Count&, const Count&) = default;
    friend std::ostream& operator<<(std::ostream& out, const Count& count) {
        return out << count.cases << " of kind " << count.kind;
    }
};

using Counts = std::map<std::string, Count>;

std::size_t lines_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string line;
    std::size_t count = 0;
    while (std::getline(file, line)) ++count;
    return count;
}

Counts counted(const std::filesystem::path& folder) {
    Counts counts;
    for (const CaseFile& file : case_files(folder))
        counts[file.family] = {file.kind, lines_of(folder / (file.family + ".jsonl"))};
    return counts;
}

// COUNTS.tsv: a heading, family, kind, cases, undecidable, and a last line with the total.
Counts stated(const std::filesystem::path& folder) {
    std::ifstream file(folder / "COUNTS.tsv");
    std::string line;
    std::getline(file, line);
    Counts counts;
    while (std::getline(file, line)) {
        std::istringstream columns(line);
        std::string family;
        Count count;
        std::getline(columns, family, '\t');
        std::getline(columns, count.kind, '\t');
        columns >> count.cases;
        counts[family] = count;
    }
    return counts;
}

std::size_t total(const Counts& counts) {
    std::size_t sum = 0;
    for (const auto& [family, count] : counts) sum += count.cases;
    return sum;
}

TEST(CaseFiles, ShippedOnesAreComplete) {
    Counts expected = stated(shipped_cases());
    ASSERT_TRUE(expected.contains("TOTAL"));
    EXPECT_EQ(expected["TOTAL"].cases, 3662U);
    expected.erase("TOTAL");
    EXPECT_EQ(expected.size(), 121U);
    EXPECT_EQ(total(expected), 3662U);
    EXPECT_THAT(counted(shipped_cases()), testing::ContainerEq(expected));
}

TEST(CaseFiles, ChosenFolderHoldsCases) {
    EXPECT_FALSE(case_files(chosen_cases()).empty())
        << "no case files (*.jsonl) in " << chosen_cases() << ", which RAYSCOPE_ORACLE names";
    if (std::filesystem::exists(chosen_cases() / "COUNTS.tsv")) {
        Counts expected = stated(chosen_cases());
        expected.erase("TOTAL");
        EXPECT_THAT(counted(chosen_cases()), testing::ContainerEq(expected));
    }
}

TEST(CaseFiles, EveryFileIsOfAKnownKind) {
    for (const CaseFile& file : case_files(chosen_cases()))
        EXPECT_THAT((std::vector<std::string>{"hit", "csg", "refr", "tri", "oct", "cavity"}),
                    testing::Contains(file.kind))
            << "in family " << file.family;
}

TEST(CaseFiles, AFolderThatIsNotThereHoldsNothing) {
    EXPECT_TRUE(case_files(shipped_cases() / "no such folder").empty());
}

TEST(CaseFiles, ABrokenLineIsNamed) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "broken.jsonl";
    std::ofstream(path) << "{\"id\": 1}\n";
    try {
        (void)read_line_cases(path);
        FAIL() << "a broken case was read";
    } catch (const std::exception& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("broken.jsonl:1: "));
    }
    EXPECT_THROW((void)read_line_cases(path.string() + ".missing"), std::runtime_error);
}

// Tests are registered for the families of the source tree, when they are built. Others are run here.
TEST(CaseFiles, FamiliesThatAreNotShipped) {
    const auto shipped = case_files(shipped_cases());
    std::size_t families = 0;
    for (const CaseFile& file : case_files(chosen_cases())) {
        if (std::ranges::find(shipped, file.family, &CaseFile::family) != shipped.end()) continue;
        SCOPED_TRACE(file.family);
        ++families;
        const bool narrow = file.epsilon == static_cast<double>(epsilon<float>);
        const NumbersChoice numbers{narrow ? ScalarType::float32 : ScalarType::float64, Method::stable};
        if (file.kind == "refr") expect_refraction(read_refraction_cases(file.path), numbers);
        if (file.kind == "tri" && !narrow) expect_triangles(read_triangle_cases(file.path));
        if (file.kind == "cavity") expect_cavity(read_cavity_cases(file.path));
        if (file.kind == "oct" && !narrow) expect_cells(read_grid_cases(file.path));
        if (file.kind != "hit" && file.kind != "csg") continue;
        const auto cases = read_line_cases(file.path);
        expect_spans(cases, numbers);
        expect_surfaces_and_normals(cases, numbers);
        expect_bounds_of_ends(cases, numbers);
        if (narrow) continue;
        expect_first_hits(cases);
        expect_error_bounds(cases);
        expect_identities(cases);
    }
    RecordProperty("families", std::to_string(families));
}

} // namespace
} // namespace rayscope::test
