#pragma once
// Where the cases are: the source tree's, or the folder that RAYSCOPE_ORACLE names.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::test {

/// One family: NAME.jsonl, with cases of one kind.
struct CaseFile {
    std::string family;
    std::string kind; ///< as its first line says; empty if that can't be read
};

[[nodiscard]] std::filesystem::path shipped_cases();
/// RAYSCOPE_ORACLE of the environment, else the shipped ones.
[[nodiscard]] std::filesystem::path chosen_cases();

/// The case files of a folder, by name; empty if there is no such folder.
[[nodiscard]] std::vector<CaseFile> case_files(const std::filesystem::path& folder);

/// Families of a kind, in the chosen folder or shipped: the names under which tests are registered. A shipped
/// one stays in the list when another folder is chosen, since ctest's list is made when the tests are built.
[[nodiscard]] std::vector<std::string> families(const std::string& kind);

/// A test of one family. It fails if the chosen folder holds no case files at all, and is skipped if it holds
/// only others.
class FamilyTest : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override;
    [[nodiscard]] std::filesystem::path path() const;
};

/// For INSTANTIATE_TEST_SUITE_P: the family's name.
[[nodiscard]] std::string family_name(const testing::TestParamInfo<std::string>& info);

} // namespace rayscope::test
