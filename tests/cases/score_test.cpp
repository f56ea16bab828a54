// The judge of number types: it counts what is wrong, measures what is lost, and finds nothing to blame in the stable
// formulas.

#include "core/cases/score_report.hpp"
#include "core/scene/input_error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rayscope::test {
namespace {

constexpr std::size_t float_stable = 0, double_stable = 2, double_textbook = 3, long_double_stable = 4,
                      float128_stable = 6;

std::filesystem::path shipped() { return std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "tests/oracle/cases"; }

// Copies of one family's lines, changed.
class Folder : public TemporaryFolder {
public:
    template <typename Change> CaseFile copy(const std::string& family, const Change& change) const {
        std::ifstream from(shipped() / (family + ".jsonl"));
        std::ofstream to(path() / (family + ".jsonl"));
        std::string line;
        while (std::getline(from, line)) {
            auto json = nlohmann::json::parse(line);
            change(json);
            to << json.dump() << '\n';
        }
        to.close();
        return case_files(path()).at(0);
    }
};

const std::vector<FamilyScores>& shipped_scores() {
    static const auto scores = score_folder(shipped());
    return scores;
}

class Stable : public testing::TestWithParam<std::size_t> {};

TEST_P(Stable, GetsNothingWrong) {
    const NumbersChoice numbers = all_numbers[GetParam()];
    int decidable = 0;
    for (const CaseFile& file : case_files(shipped())) {
        const bool about_float = file.epsilon == double(epsilon<float>);
        if (about_float != (numbers.scalar == ScalarType::float32)) continue;
        const auto found = score(file, numbers);
        if (!found) continue;
        decidable += found->decidable;
        EXPECT_EQ(found->wrong, 0) << file.family;
        // The reference type has no wider one to invert a matrix in: it may lose a digit to the matrix's condition.
        if (GetParam() == float128_stable)
            EXPECT_FALSE(found->digits_lost > 1) << file.family;
        else
            EXPECT_EQ(found->off, 0) << file.family;
    }
    EXPECT_GT(decidable, 900);
}
INSTANTIATE_TEST_SUITE_P(, Stable,
                         testing::Values(float_stable, double_stable, long_double_stable, float128_stable),
                         [](const auto& tested) {
                             std::string name(scalar_name(all_numbers[tested.param].scalar));
                             std::erase(name, ' ');
                             return name;
                         });

TEST(Score, TheSchoolbookLosesDigitsAndRays) {
    int wrong = 0;
    for (const FamilyScores& row : shipped_scores())
        if (row.scores[double_textbook]) wrong += row.scores[double_textbook]->wrong;
    EXPECT_GT(wrong, 50);
}

TEST(Score, CountsAWrongNumberOfHits) {
    const Folder folder;
    const CaseFile file = folder.copy("rim", [](auto& json) { json["intervals"] = nlohmann::json::array(); });
    const auto found = score(file, all_numbers[double_stable]);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->decidable, 39);
    EXPECT_GT(found->wrong, 20); // a line beside a rim has no interval anyway
    EXPECT_EQ(found->off, 0);
}

TEST(Score, MeasuresHowFarAHitIsOff) {
    const Folder folder;
    const CaseFile file = folder.copy("plane_grazing", [](auto& json) {
        for (auto& hit : json["hits"]) { // t ± 10⁴ ε cond
            const double t = std::strtod(hit["t_hex"].template get<std::string>().c_str(), nullptr);
            const double moved = t + 1e4 * 0x1p-52 * hit["cond_tight"].template get<double>();
            char text[40];
            std::snprintf(text, sizeof text, "%a", moved);
            hit["t_hex"] = text;
            hit["t_lo_hex"] = "0x0p+0";
            std::snprintf(text, sizeof text, "%.17g", moved);
            hit["t_str"] = text;
        }
    });
    const auto found = score(file, all_numbers[double_stable]);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->wrong, 0);
    EXPECT_EQ(found->off, found->decidable);
    EXPECT_NEAR(found->digits_lost, 4, 0.1);
}

TEST(Score, FloatIsJudgedOnItsOwnInputs) {
    for (const FamilyScores& row : shipped_scores()) {
        EXPECT_FALSE(row.family.ends_with("_f32"));
        if (row.family != "sphere_grazing") continue;
        EXPECT_EQ(row.scores[float_stable]->decidable, 18);
        EXPECT_EQ(row.scores[double_stable]->decidable, 63);
    }
}

TEST(Score, ABrokenProgramIsRefusedWithItsLine) {
    const Folder folder;
    const auto broken = [&](const char* program) {
        const CaseFile file =
            folder.copy("csg_generic", [&](auto& json) { json["rpn"] = nlohmann::json::parse(program); });
        try {
            (void)score(file, {});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    using testing::HasSubstr;
    EXPECT_THAT(broken("[0, \"&\"]"), HasSubstr("csg_generic.jsonl:1: expected a case of the oracle: rpn: an "
                                                "operation lacks an operand"));
    EXPECT_THAT(broken("[0, 99, \"&\"]"), HasSubstr("rpn names leaf 99"));
    EXPECT_THAT(broken("[0, 0]"), HasSubstr("rpn leaves 2 results, expected 1"));
    EXPECT_THAT(broken("[]"), HasSubstr("rpn leaves 0 results, expected 1"));
}

TEST(Score, JsonHoldsWhatTheTableShows) {
    const auto json = nlohmann::json::parse(scores_json(shipped_scores()));
    EXPECT_EQ(json["format"], "rayscope-cases");
    int stable_wrong = 0, textbook_wrong = 0;
    for (const auto& row : json["scores"])
        (row["method"] == "stable" ? stable_wrong : textbook_wrong) += row["wrong"].get<int>();
    EXPECT_EQ(stable_wrong, 0);
    EXPECT_GT(textbook_wrong, 100);
    const std::string table = scores_table(shipped_scores());
    EXPECT_THAT(table, testing::HasSubstr("torus_top_quad"));
    EXPECT_THAT(table, testing::HasSubstr("double: textbook"));
}

} // namespace
} // namespace rayscope::test
