// What is handed out as a zip file: it holds what it needs, and no more than its reader may see.

#include "exercises/grader/child.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <filesystem>

namespace rayscope::test {
namespace {

using exercises::Child;
using testing::HasSubstr;
using testing::Not;

/// What the command prints, its errors included; a failure of the test if it fails.
std::string output_of(const std::vector<std::string>& command) {
    Child child(command, {}, Child::Errors::with_output);
    const auto ended = child.finish(1U << 20U, std::chrono::minutes(2));
    EXPECT_TRUE(ended && ended->code == 0)
        << command.at(0) << ": " << (ended ? ended->output : "does not end");
    return ended ? ended->output : "";
}

class Package : public testing::Test {
protected:
    [[nodiscard]] std::filesystem::path folder() const { return folder_.path(); }
    /// Makes it, and unpacks it.
    void make(const std::vector<std::string>& options = {}) const {
        const auto programs = std::filesystem::path(RAYSCOPE_PROGRAM).parent_path();
        const std::string zip = (folder() / "package.zip").string();
        std::vector<std::string> command{(programs / "rayscope-exercises").string(), "package", "-o", zip};
        command.insert(command.end(), options.begin(), options.end());
        (void)output_of(command);
        (void)output_of({"env", "-C", folder().string(), "cmake", "-E", "tar", "xf", zip});
    }

private:
    TemporaryFolder folder_;
};

TEST_F(Package, for_Gradescope_can_be_configured_as_it_stands) {
    make();
    EXPECT_TRUE(exists(folder() / "setup.sh") && exists(folder() / "run_autograder"));
    EXPECT_THAT(output_of({"cmake", "-S", (folder() / "rayscope").string(), "-B",
                           (folder() / "build").string(), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                           "-DRAYSCOPE_VISUALIZER=OFF", "-DRAYSCOPE_BENCH=OFF", "-DBUILD_TESTING=OFF"}),
                HasSubstr("Build files have been written"));
}

TEST_F(Package, for_students_holds_no_solution) {
    make({"--student"});
    const std::string files = output_of({"find", folder().string(), "-type", "f"});
    EXPECT_THAT(files, HasSubstr("1-03-sphere.hpp"));
    EXPECT_THAT(files, Not(HasSubstr("solution")));
    EXPECT_THAT(files, Not(HasSubstr("misconceptions")));
    EXPECT_THAT(files, Not(HasSubstr("cases.cpp")));
}

} // namespace
} // namespace rayscope::test
