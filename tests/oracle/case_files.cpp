#include "tests/oracle/case_files.hpp"

#include <algorithm>
#include <cstdlib>

namespace rayscope::test {
namespace {

// Read once: each test is a process of its own, which asks for many lists of families before it runs.
const std::vector<CaseFile>& chosen_files() {
    static const auto files = case_files(chosen_cases());
    return files;
}

/// Those chosen, and the shipped families that are not among them.
const std::vector<CaseFile>& all_files() {
    static const auto files = [] {
        std::vector<CaseFile> found = chosen_files();
        if (chosen_cases() == shipped_cases()) return found;
        for (const CaseFile& shipped : case_files(shipped_cases()))
            if (std::ranges::find(found, shipped.family, &CaseFile::family) == found.end())
                found.push_back(shipped);
        return found;
    }();
    return files;
}

} // namespace

std::filesystem::path shipped_cases() {
    return std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "tests/oracle/cases";
}

std::filesystem::path chosen_cases() {
    const char* folder = std::getenv("RAYSCOPE_ORACLE");
    return folder != nullptr ? std::filesystem::path(folder) : shipped_cases();
}

std::vector<std::string> families(const std::string& kind, double epsilon) {
    std::vector<std::string> names;
    for (const CaseFile& file : all_files())
        if (file.kind == kind && file.epsilon == epsilon) names.push_back(file.family);
    return names;
}

void FamilyTest::SetUp() {
    if (chosen_files().empty())
        FAIL() << "no case files (*.jsonl) in " << chosen_cases() << ", which RAYSCOPE_ORACLE names";
    if (!std::filesystem::exists(path())) GTEST_SKIP() << chosen_cases() << " has no family " << GetParam();
}

std::filesystem::path FamilyTest::path() const { return chosen_cases() / (GetParam() + ".jsonl"); }

std::string family_name(const testing::TestParamInfo<std::string>& info) {
    std::string name = info.param;
    std::ranges::replace_if(name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
}

} // namespace rayscope::test
