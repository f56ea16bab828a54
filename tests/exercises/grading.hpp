#pragma once
// The grader, ready for tests.

#include "exercises/grader/grade.hpp"
#include "exercises/grader/sandbox.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace rayscope::test {

/// All shipped exercises.
[[nodiscard]] const std::vector<exercises::Exercise>& catalogue();
/// Their ids, for tests of each of them.
[[nodiscard]] std::vector<std::string> ids();
/// An id, or what else such a test is named by, as GoogleTest takes it.
[[nodiscard]] std::string test_name(std::string id);

/// The sandbox and the compiler, with a cache of the tests' own.
[[nodiscard]] const exercises::Toolchain& toolchain();

/// Tests that run foreign code; skipped, and told so, where the system allows no sandbox.
class InSandbox : public testing::Test {
protected:
    void SetUp() override;
};

} // namespace rayscope::test
