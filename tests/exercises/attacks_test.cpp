// Submissions that want points, or harm, without earning them. Each file of attacks/ names in its first line how at
// least one of its runs ends; none may have more points than its honest part, which returns no span.

#include "exercises/grader/served_formulas.hpp"
#include "exercises/grader/units.hpp"
#include "tests/exercises/grading.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;
using namespace exercises;
using exercises::Reference; // not rayscope's own

const fs::path attacks = RAYSCOPE_SOURCE_DIR "/tests/exercises/attacks";

const std::map<std::string, OutcomeKind> kinds{
    {"answered", OutcomeKind::answered},       {"threw", OutcomeKind::threw},
    {"crashed", OutcomeKind::crashed},         {"timed_out", OutcomeKind::timed_out},
    {"ended_early", OutcomeKind::ended_early}, {"no_value", OutcomeKind::no_value},
    {"too_much", OutcomeKind::too_much},       {"unsteady", OutcomeKind::unsteady}};

const Reference& sphere() {
    static const Reference reference =
        make_reference(toolchain(), find_exercise(catalogue(), "1-03-sphere"), 4711);
    return reference;
}

std::vector<std::string> names(bool slow) {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(attacks))
        if ((content_of(entry.path()).find("\n// slow\n") != std::string::npos) == slow)
            found.push_back(entry.path().stem());
    std::sort(found.begin(), found.end());
    return found;
}

double honest_score() {
    static const double score = grade(toolchain(), sphere(), content_of(attacks / "honest.attack")).score;
    return score;
}

void gains_nothing(const std::string& name) {
    const std::string code = content_of(attacks / (name + ".attack"));
    const std::string expected = code.substr(9, code.find('\n') - 9); // behind "// ends: "
    const Grade result = grade(toolchain(), sphere(), code);
    EXPECT_LE(result.score, honest_score());
    EXPECT_LT(honest_score(), 15);
    if (expected == "does not compile") {
        EXPECT_FALSE(result.compiled);
        EXPECT_EQ(result.score, 0);
        EXPECT_TRUE(!result.problem.empty() || std::ranges::any_of(result.diagnostics, &Diagnostic::error))
            << "no verdict is given";
        return;
    }
    ASSERT_TRUE(kinds.contains(expected)) << expected;
    EXPECT_TRUE(result.compiled) << result.problem;
    const auto ended = std::ranges::count(result.cases, kinds.at(expected),
                                          [](const CaseResult& one) { return one.outcome.kind; });
    EXPECT_GT(ended, 0) << "it ended as: " << (result.cases.empty() ? "" : text_of(result.cases[0].outcome));
}

class Attacks : public InSandbox, public testing::WithParamInterface<std::string> {};
TEST_P(Attacks, gain_nothing) { gains_nothing(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Quick, Attacks, testing::ValuesIn(names(false)),
                         [](const auto& one) { return one.param; });

class AttacksFull : public Attacks {};
TEST_P(AttacksFull, gain_nothing) { gains_nothing(GetParam()); }
INSTANTIATE_TEST_SUITE_P(Slow, AttacksFull, testing::ValuesIn(names(true)),
                         [](const auto& one) { return one.param; });

TEST(AttackFiles, are_many) { EXPECT_GE(names(false).size() + names(true).size(), 60U); }

class Grader : public InSandbox {};

TEST_F(Grader, knows_no_code_in_bytes) {
    const Grade result = grade(toolchain(), sphere(), std::string("\xff\xfe\0binary\x01", 10));
    EXPECT_FALSE(result.compiled);
    EXPECT_EQ(result.score, 0);
}

// Who learnt the practice cases by heart has the points of none of them in another seed.
TEST_F(Grader, rewards_no_answers_learnt_by_heart) {
    const Exercise& exercise = *sphere().exercise;
    const Reference practice = make_reference(toolchain(), exercise, 1);
    std::string code = "Spans sphere(const Ray& r) {\n";
    for (std::size_t i = 0; i < practice.cases.size(); ++i) {
        const std::string ray = text_of(practice.cases[i].arguments[0]),
                          answer = text_of(practice.outcomes[0][i].value);
        code += "    if (const Ray k = " + ray + "; k.o == r.o && k.d == r.d) return " + answer + ";\n";
    }
    code += "    return {};\n}\n";
    const Grade known = grade(toolchain(), practice, code), other = grade(toolchain(), sphere(), code);
    EXPECT_EQ(known.score, 15);
    EXPECT_LE(other.score, honest_score());
}

// Where many answers are right, one without end is not.
TEST_F(Grader, takes_no_point_that_is_infinitely_far_away) {
    const Exercise& exercise = find_exercise(catalogue(), "7-03-spawn");
    const Reference reference = make_reference(toolchain(), exercise, 4711);
    for (const std::string far : {"INF", "std::numeric_limits<double>::max()", "1e300", "NAN"}) {
        const Grade result = grade(toolchain(), reference,
                                   "dvec3 spawn(dvec3 p, dvec3 err, dvec3 n, dvec3 d) {\n"
                                   "    for (int i = 0; i < 3; ++i)\n"
                                   "        if (const double to = (dot(d, n) < 0 ? -1 : 1) * n[i]; "
                                   "to != 0) p[i] = std::copysign(" +
                                       far +
                                       ", to);\n"
                                       "    return p;\n}\n");
        EXPECT_TRUE(result.compiled) << far;
        EXPECT_EQ(result.score, 0) << far;
    }
}

// One that takes its time with every call is not waited for as long as there are calls.
TEST_F(Grader, draws_no_ray_of_a_function_that_answers_slowly) {
    const Exercise& exercise = find_exercise(catalogue(), "3-01-mirror");
    const PrivateFolder folder(toolchain().cache());
    const Compiled slow = toolchain().compile(
        answer_unit(exercise,
                    "#include <unistd.h>\ndvec3 mirror(const dvec3&, const dvec3& d, const dvec3&) {\n"
                    "    sleep(3);\n    return d;\n}\n"),
        folder.path() / "program");
    const Formulas formulas = served_formulas(toolchain(), exercise, slow.program, std::chrono::seconds(5));
    EXPECT_EQ(formulas.mirror(Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 0, 1)), Vec3d(1, 0, 0));
    EXPECT_THROW((void)formulas.mirror(Vec3d(0), Vec3d(1, 0, 0), Vec3d(0, 0, 1)), std::runtime_error);
}

// One case of all takes longer than a second of the processor, and less than two.
TEST_F(Grader, grants_two_seconds_of_computing) {
    const Grade result = grade(toolchain(), sphere(), R"(#include <ctime>
Spans sphere(const Ray& r) {
    if (glm::dot(r.d, r.d) == 4 && (r.d.x == 0 || r.d.y == 0))
        while (std::clock() < CLOCKS_PER_SEC * 3 / 2) {
        }
    return {};
})");
    for (const CaseResult& one : result.cases) EXPECT_EQ(one.outcome.kind, OutcomeKind::answered);
}

TEST_F(Grader, gives_the_same_verdict_after_all_that) {
    const std::string solution = content_of(sphere().exercise->solution());
    EXPECT_TRUE(grade(toolchain(), sphere(), solution).all_right());
}

} // namespace
} // namespace rayscope::test
