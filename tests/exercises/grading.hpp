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

/// The sandbox and the compiler, with a cache of the tests' own.
[[nodiscard]] const exercises::Toolchain& toolchain();

/// Tests that run foreign code; skipped, and told so, where the system allows no sandbox.
class InSandbox : public testing::Test {
protected:
    void SetUp() override;
};

} // namespace rayscope::test
