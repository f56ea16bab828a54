// A student's workspace: made once, never overwritten, with progress that survives.

#include "core/files/atomic_file.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/overview.hpp"
#include "tests/exercises/grading.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>

namespace rayscope::test {
namespace {

using namespace exercises;
using testing::HasSubstr;
using testing::Not;

class Student : public testing::Test {
protected:
    void SetUp() override {
        setenv("XDG_STATE_HOME", (folder_.path() / "state").c_str(), 1);
        (void)start_workspace(home(), catalogue());
    }
    [[nodiscard]] std::filesystem::path home() const { return folder_.path() / "mine"; }
    [[nodiscard]] Workspace workspace() const { return Workspace(home()); }
    [[nodiscard]] static const Exercise& sphere() { return find_exercise(catalogue(), "sphere"); }

private:
    TemporaryFolder folder_;
};

TEST_F(Student, starts_with_a_stub_of_each_exercise) {
    for (const Exercise& exercise : catalogue())
        EXPECT_EQ(content_of(workspace().file(exercise)), content_of(exercise.stub())) << exercise.id;
}

TEST_F(Student, keeps_work_when_started_again) {
    write_text_file(workspace().file(sphere()), "my work");
    EXPECT_TRUE(start_workspace(home(), catalogue()).empty());
    EXPECT_EQ(content_of(workspace().file(sphere())), "my work");
}

TEST_F(Student, can_not_start_in_the_source_tree) {
    const std::filesystem::path inside = RAYSCOPE_SOURCE_DIR "/exercises/mine";
    EXPECT_THROW((void)start_workspace(inside, catalogue()), UsageError);
    EXPECT_FALSE(std::filesystem::exists(inside));
}

TEST_F(Student, finds_the_workspace_that_was_started_last) {
    EXPECT_EQ(find_workspace(std::nullopt).folder(), home());
    EXPECT_THROW((void)find_workspace(home() / "tasks"), UsageError);
}

TEST_F(Student, has_progress_that_survives_a_broken_file) {
    workspace().update([](Progress& progress) { progress["1-03-sphere"] = {7.5, false, 2}; });
    EXPECT_EQ(workspace().progress().at("1-03-sphere").best, 7.5);
    EXPECT_EQ(workspace().progress().at("1-03-sphere").hints, 2);
    write_text_file(home() / ".rayscope/progress.json", "{\"exercises\":");
    EXPECT_TRUE(workspace().progress().empty());
    EXPECT_TRUE(std::filesystem::exists(home() / ".rayscope/progress.json.broken"));
}

TEST_F(Student, gets_one_hint_more_each_time) {
    const auto& hints = sphere().hints;
    EXPECT_THAT(hint_text(sphere(), workspace()), HasSubstr("hint 1 of 3"));
    const std::string second = hint_text(sphere(), workspace());
    EXPECT_THAT(second, HasSubstr(hints[0].substr(0, 20)));
    EXPECT_THAT(second, HasSubstr(hints[1].substr(0, 20)));
    EXPECT_THAT(second, Not(HasSubstr(hints[2].substr(0, 20))));
    (void)hint_text(sphere(), workspace());
    EXPECT_THAT(hint_text(sphere(), workspace()), HasSubstr("no more hints"));
}

TEST_F(Student, keeps_every_file_that_is_reset) {
    for (const char* work : {"first", "second"}) {
        write_text_file(workspace().file(sphere()), work);
        (void)reset_text(sphere(), workspace());
        EXPECT_EQ(content_of(workspace().file(sphere())), content_of(sphere().stub()));
    }
    EXPECT_EQ(content_of(home() / "1-03-sphere.hpp.1.bak"), "first");
    EXPECT_EQ(content_of(home() / "1-03-sphere.hpp.2.bak"), "second");
}

TEST(NextExercise, waits_for_prerequisites_and_ends) {
    Progress progress;
    EXPECT_EQ(next_exercise(catalogue(), progress)->id, "1-01-to-object");
    for (const Exercise& exercise : catalogue()) progress[exercise.id].passed = true;
    EXPECT_EQ(next_exercise(catalogue(), progress), nullptr);
    EXPECT_THAT(summary_text(catalogue(), progress), HasSubstr("You are done"));
    progress["3-01-mirror"].passed = progress["3-02-chain"].passed = false;
    EXPECT_EQ(next_exercise(catalogue(), progress)->id, "3-01-mirror");
}

TEST(Predicted, takes_numbers_and_words) {
    const Prediction number{"", "19.5", ""}, word{"", "(A-B)&C", ""};
    EXPECT_TRUE(predicted(number, " 19.47 "));
    EXPECT_FALSE(predicted(number, "19"));
    EXPECT_TRUE(predicted(word, "( a-b ) & c"));
    EXPECT_FALSE(predicted(word, "A-(B&C)"));
    EXPECT_FALSE(predicted({"", "0", ""}, "nan"));
}

} // namespace
} // namespace rayscope::test
