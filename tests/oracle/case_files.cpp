#include "tests/oracle/case_files.hpp"

#include <algorithm>
#include <cstdlib>

namespace rayscope::test {
std::filesystem::path shipped_cases() {
    return std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "tests/oracle/cases";
}

std::filesystem::path chosen_cases() {
    const char* folder = std::getenv("RAYSCOPE_ORACLE");
    return folder != nullptr ? std::filesystem::path(folder) : shipped_cases();
}

std::vector<std::string> families(const std::string& kind, double epsilon) {
    std::vector<CaseFile> files = case_files(chosen_cases());
    for (const CaseFile& shipped : case_files(shipped_cases()))
        if (std::ranges::find(files, shipped.family, &CaseFile::family) == files.end())
            files.push_back(shipped);
    std::vector<std::string> names;
    for (const CaseFile& file : files)
        if (file.kind == kind && file.epsilon == epsilon) names.push_back(file.family);
    return names;
}

void FamilyTest::SetUp() {
    if (case_files(chosen_cases()).empty())
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
