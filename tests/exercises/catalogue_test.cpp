// The shipped exercises: complete, and each one tests what it says.

#include "core/files/atomic_file.hpp"
#include "exercises/grader/verify.hpp"
#include "tests/exercises/grading.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <map>

namespace rayscope::test {
namespace {

using namespace exercises;
using testing::IsEmpty;

TEST(Catalogue, has_28_exercises_in_8_chapters_of_100_points) {
    std::map<int, int> points;
    for (const Exercise& exercise : catalogue()) points[exercise.chapter] += exercise.points;
    EXPECT_EQ(catalogue().size(), 28U);
    EXPECT_EQ(points.size(), 8U);
    for (const auto& [chapter, sum] : points) EXPECT_EQ(sum, 100) << "chapter " << chapter;
}

TEST(Catalogue, asks_first_for_exercises_that_come_first) {
    for (const Exercise& exercise : catalogue())
        for (const std::string& id : exercise.prerequisites)
            EXPECT_LT(find_exercise(catalogue(), id).id, exercise.id) << exercise.id;
}

TEST(Catalogue, hides_the_hard_group_alone) {
    for (const Exercise& exercise : catalogue())
        for (const Group& group : exercise.groups)
            EXPECT_EQ(group.hidden, group.name == "hard") << exercise.id;
}

std::vector<std::uint64_t> seeds(std::uint64_t count) {
    std::vector<std::uint64_t> list;
    for (std::uint64_t seed = 1; seed <= count; ++seed) list.push_back(seed);
    return list;
}

class Exercises : public InSandbox, public testing::WithParamInterface<std::string> {};
TEST_P(Exercises, test_what_they_say) {
    EXPECT_THAT(problems_of(toolchain(), find_exercise(catalogue(), GetParam()), seeds(3)), IsEmpty());
}
INSTANTIATE_TEST_SUITE_P(Quick, Exercises, testing::ValuesIn(ids()),
                         [](const auto& one) { return test_name(one.param); });

class ExercisesFull : public Exercises {};
TEST_P(ExercisesFull, test_what_they_say_for_100_seeds) {
    EXPECT_THAT(problems_of(toolchain(), find_exercise(catalogue(), GetParam()), seeds(100)), IsEmpty());
}
INSTANTIATE_TEST_SUITE_P(Slow, ExercisesFull, testing::ValuesIn(ids()),
                         [](const auto& one) { return test_name(one.param); });

TEST_F(InSandbox, verification_finds_a_case_that_can_not_be_shown) {
    const TemporaryFolder folder;
    const Exercise& pays = find_exercise(catalogue(), "pays");
    std::filesystem::copy(pays.folder, folder.path() / "9-01-pays", std::filesystem::copy_options::recursive);
    Exercise copy = read_exercise(folder.path() / "9-01-pays");
    const std::string cases = content_of(copy.cases());
    write_text_file(copy.cases(),
                    cases.substr(0, cases.find("/// A ray that pays")) +
                        "Shown show(double, double, double) { return {\"[generics.x]\", {}}; }\n");
    EXPECT_THAT(problems_of(toolchain(), copy, seeds(1)),
                testing::Contains(testing::HasSubstr("show() makes no scene of")));
}

TEST(Renamed, changes_variables_and_nothing_else) {
    Exercise exercise;
    exercise.functions = {{"double f(const Ray& d)", "f"}};
    EXPECT_EQ(renamed("double f(const Ray& d) { const double b = d.d.x; return b + r.b; }", exercise),
              "double f(const Ray& other_d) { const double other_b = other_d.d.x; return other_b + r.b; }");
}

} // namespace
} // namespace rayscope::test
