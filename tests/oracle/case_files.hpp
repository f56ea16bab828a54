#pragma once
// Where the cases are: the source tree's, or the folder that RAYSCOPE_ORACLE names.

#include "core/cases/case_files.hpp"
#include "core/cases/read_cases.hpp"
#include "core/math/scalar.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::test {

[[nodiscard]] std::filesystem::path shipped_cases();
/// RAYSCOPE_ORACLE of the environment, else the shipped ones.
[[nodiscard]] std::filesystem::path chosen_cases();

/// Families of a kind, about the numbers of an ε, in the chosen folder or shipped: the names under which tests are registered. A shipped
/// one stays in the list when another folder is chosen, since ctest's list is made when the tests are built.
[[nodiscard]] std::vector<std::string> families(const std::string& kind,
                                                double epsilon = rayscope::epsilon<double>);

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
