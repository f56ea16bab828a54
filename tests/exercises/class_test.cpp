// A class, graded: the same bytes each time, and nothing lost where it was stopped.

#include "core/files/atomic_file.hpp"
#include "core/scene/input_error.hpp"
#include "exercises/grader/results.hpp"
#include "exercises/grader/submissions.hpp"
#include "exercises/program/commands.hpp"
#include "tests/exercises/grading.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;
using namespace exercises;
using testing::HasSubstr;
using testing::Not;

const Exercise& pays() { return find_exercise(catalogue(), "pays"); }

class Class : public InSandbox {
protected:
    void hand_in(const std::string& student, const std::string& code,
                 const Exercise& exercise = pays()) const {
        fs::create_directories(folder_.path() / "class" / student);
        write_text_file(folder_.path() / "class" / student / exercise.file_name(), code);
    }
    [[nodiscard]] fs::path graded(const std::string& output, std::uint64_t seed = 7) const {
        (void)toolchain(); // chooses the tests' cache
        GradeAll command;
        command.submissions = {folder_.path() / "class"};
        command.output = folder_.path() / output;
        Context context{{}, catalogue()};
        context.options.seed = seed;
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        EXPECT_EQ(run(context, command), 0);
        (void)testing::internal::GetCapturedStdout();
        (void)testing::internal::GetCapturedStderr();
        return command.output;
    }
    [[nodiscard]] const fs::path& folder() const { return folder_.path(); }

private:
    TemporaryFolder folder_;
};

std::vector<std::string> contents(const fs::path& folder) {
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            all.push_back(entry.path().lexically_relative(folder).string() + "\n" + content_of(entry.path()));
    std::sort(all.begin(), all.end());
    return all;
}

TEST_F(Class, has_the_same_results_each_time_and_goes_on_where_it_stopped) {
    hand_in("ada", content_of(pays().solution()));
    hand_in("ben", content_of(pays().misconceptions[0].file));
    hand_in("cy", "bool pays(double, double, double) { return 1 +; }");
    hand_in("-rf = \xff\"", content_of(pays().misconceptions[1].file));
    const fs::path first = graded("first"), second = graded("second");
    EXPECT_EQ(contents(first), contents(second));

    // Stopped in between: of one student the record is missing, of another it is cut off.
    fs::remove(second / ".state/ada.json");
    fs::remove_all(second / "students/ada");
    write_text_file(second / ".state/ben.json", content_of(second / ".state/ben.json").substr(0, 100));
    fs::remove(second / "class.csv");
    EXPECT_EQ(contents(graded("second")), contents(first));
    // What was handed in anew is graded anew.
    hand_in("ben", content_of(pays().solution()));
    EXPECT_THAT(content_of(graded("second") / "class.csv"), HasSubstr("ben,15,15,15,\n"));
    EXPECT_NE(contents(graded("other", 8)), contents(first));
}

TEST_F(Class, has_tables_that_tell_what_went_wrong) {
    hand_in("ada", content_of(pays().solution()));
    hand_in("ben", content_of(pays().misconceptions[0].file));
    hand_in("=cmd()", content_of(pays().misconceptions[0].file));
    const fs::path output = graded("output");
    const std::string table = content_of(output / "class.csv"), items = content_of(output / "items.csv");
    EXPECT_THAT(table, HasSubstr("student,score,points,5-03-pays,5-03-pays remark\n'=cmd(),"));
    EXPECT_THAT(table, HasSubstr("ada,15,15,15,\n"));
    EXPECT_THAT(items, HasSubstr("notes: 2"));
    EXPECT_THAT(content_of(output / "junit.xml"),
                HasSubstr("<testsuites name=\"rayscope exercises\" tests=\"9\""));
    EXPECT_THAT(content_of(output / "students/ben/report.html"),
                HasSubstr("A cube is not cheaper than a sphere"));
}

TEST_F(Class, has_reports_that_draw_the_wrong_ray_over_the_right_one) {
    const Exercise &mirror = find_exercise(catalogue(), "mirror"), &stop = find_exercise(catalogue(), "stop");
    hand_in("ada", content_of(mirror.solution()), mirror);
    hand_in("ben", content_of(mirror.folder / "misconceptions/slide.hpp"), mirror);
    hand_in("cy", content_of(stop.folder / "misconceptions/single.hpp"), stop);
    const fs::path students = graded("output") / "students";
    const auto report = [&](const char* student) { return content_of(students / student / "report.html"); };
    EXPECT_THAT(report("ada"), Not(HasSubstr("The ray of this case")));
    for (const char* student : {"ben", "cy"}) {
        EXPECT_THAT(report(student), HasSubstr("right: solid line, filled bar"));
        EXPECT_THAT(report(student), HasSubstr("yours: dashed line, hollow bar"));
        EXPECT_THAT(report(student), HasSubstr("<line class=\"right\" x1"));
        EXPECT_THAT(report(student), HasSubstr("<line class=\"yours\" x1"));
    }
    EXPECT_THAT(report("ben"), HasSubstr("The first divergence, at ray 0: the direction of a ray"));
    EXPECT_THAT(report("cy"), HasSubstr(": whether a ray goes on"));
    EXPECT_TRUE(fs::exists(students / "cy/rays/3-03-stop.yours.toml"));
    EXPECT_THAT(report("cy"),
                HasSubstr("rayscope diff rays/3-03-stop.toml rays/3-03-stop.yours.toml --ray="));
}

TEST_F(Class, has_results_in_the_form_of_gradescope) {
    hand_in("ben", content_of(pays().misconceptions[0].file));
    const auto results = nlohmann::json::parse(content_of(graded("output") / "students/ben/results.json"));
    EXPECT_TRUE(results.at("score").is_number());
    EXPECT_TRUE(results.at("execution_time").is_number());
    EXPECT_TRUE(results.at("output").is_string());
    ASSERT_EQ(results.at("tests").size(), 3U);
    double sum = 0;
    for (const auto& test : results["tests"]) {
        for (const char* key : {"score", "max_score"}) EXPECT_TRUE(test.at(key).is_number()) << key;
        for (const char* key : {"name", "number", "output", "output_format"})
            EXPECT_TRUE(test.at(key).is_string()) << key;
        EXPECT_THAT((std::vector<std::string>{"passed", "failed"}),
                    testing::Contains(test.at("status").get<std::string>()));
        EXPECT_EQ(test.at("visibility"),
                  test["name"].get<std::string>().ends_with("(hidden)") ? "after_published" : "visible");
        sum += test["score"].get<double>();
    }
    EXPECT_EQ(results["score"], sum);
    EXPECT_THAT(results["output"].get<std::string>(), HasSubstr("5 of them are for hidden cases"));
    EXPECT_THAT(results["tests"][2]["output"].get<std::string>(),
                Not(HasSubstr("asked"))); // a hidden case's numbers
}

TEST_F(Class, hands_in_no_links) {
    hand_in("ada", content_of(pays().solution()));
    hand_in("eve", "");
    fs::remove(folder() / "class/eve" / pays().file_name());
    fs::create_symlink(folder() / "class/ada" / pays().file_name(),
                       folder() / "class/eve" / pays().file_name());
    fs::create_directory_symlink(folder() / "class/ada", folder() / "class/mallory");
    const Submissions found = find_submissions({folder() / "class"}, catalogue());
    ASSERT_EQ(found.list.size(), 2U);
    EXPECT_EQ(found.list[1].student, "eve");
    EXPECT_TRUE(found.list[1].files.empty());
    EXPECT_THROW((void)find_submissions({folder() / "nowhere"}, catalogue()), InputError);
}

} // namespace
} // namespace rayscope::test
