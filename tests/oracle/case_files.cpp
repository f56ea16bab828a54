#include "tests/oracle/case_files.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace rayscope::test {
namespace {

std::string kind_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    const auto json = nlohmann::json::parse(line, nullptr, false);
    if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string()) return {};
    return json["kind"].get<std::string>();
}

} // namespace

std::filesystem::path shipped_cases() {
    return std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "tests/oracle/cases";
}

std::filesystem::path chosen_cases() {
    const char* folder = std::getenv("RAYSCOPE_ORACLE");
    return folder != nullptr ? std::filesystem::path(folder) : shipped_cases();
}

std::vector<CaseFile> case_files(const std::filesystem::path& folder) {
    std::vector<CaseFile> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (entry.path().extension() == ".jsonl")
            files.push_back({entry.path().stem().string(), kind_of(entry.path())});
    std::ranges::sort(files, {}, &CaseFile::family);
    return files;
}

std::vector<std::string> families(const std::string& kind) {
    std::vector<CaseFile> files = case_files(chosen_cases());
    for (const CaseFile& shipped : case_files(shipped_cases()))
        if (std::ranges::find(files, shipped.family, &CaseFile::family) == files.end())
            files.push_back(shipped);
    std::vector<std::string> names;
    for (const CaseFile& file : files)
        if (file.kind == kind) names.push_back(file.family);
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
