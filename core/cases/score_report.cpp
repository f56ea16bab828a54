#include "core/cases/score_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

using Cells = std::vector<std::string>;

// The schoolbook's formulas before the stable ones: what is lost, and what it takes to keep it.
constexpr std::array<std::size_t, 8> columns{1, 0, 3, 2, 5, 4, 7, 6};
static_assert(all_numbers[columns[0]] == NumbersChoice{ScalarType::float32, Method::textbook});

std::string digits(double lost) { return std::isnan(lost) ? "–" : fmt::format("{:.1f}", lost); }

std::string cell(const std::optional<Score>& score) {
    if (!score || score->decidable == 0) return "–";
    return fmt::format("{:>3} {:>4}", score->wrong, digits(score->digits_lost));
}

std::string decidable(const FamilyScores& row, ScalarType scalar) {
    for (std::size_t k = 0; k < all_numbers.size(); ++k)
        if (all_numbers[k].scalar == scalar && row.scores[k]) return std::to_string(row.scores[k]->decidable);
    return "0";
}

Cells cells(const FamilyScores& row) {
    Cells result{row.family, decidable(row, ScalarType::float32), decidable(row, ScalarType::float64)};
    for (const std::size_t k : columns) result.push_back(cell(row.scores[k]));
    return result;
}

struct Sum {
    int decidable = 0, wrong = 0, off = 0;
    std::vector<double> lost;
};

Sum sum(const std::vector<FamilyScores>& families, std::size_t k) {
    Sum result;
    for (const FamilyScores& row : families) {
        if (!row.scores[k]) continue;
        result.decidable += row.scores[k]->decidable;
        result.wrong += row.scores[k]->wrong;
        result.off += row.scores[k]->off;
        if (!std::isnan(row.scores[k]->digits_lost)) result.lost.push_back(row.scores[k]->digits_lost);
    }
    return result;
}

Score total(const Sum& column) {
    Score score{column.decidable, column.wrong, column.off};
    if (!column.lost.empty()) score.digits_lost = std::ranges::max(column.lost);
    return score;
}

Cells sums(const std::vector<FamilyScores>& families) {
    Cells result{"all: wrong, worst", std::to_string(sum(families, 0).decidable),
                 std::to_string(sum(families, 2).decidable)};
    for (const std::size_t k : columns) {
        const Sum column = sum(families, k);
        result.push_back(cell(total(column)));
    }
    return result;
}

// Columns as wide as characters, not bytes.
std::string row_text(const Cells& row) {
    std::string line = fmt::format("{:<22}{:>5}{:>5}", row[0], row[1], row[2]);
    for (std::size_t i = 3; i < row.size(); ++i) line += fmt::format("{:>{}}", row[i], i % 2 == 1 ? 11 : 9);
    return line + "\n";
}

bool tells_something(const FamilyScores& row) {
    return std::ranges::any_of(row.scores, [](const std::optional<Score>& score) {
        return score && (score->wrong > 0 || score->digits_lost >= 1);
    });
}

std::string short_cell(const std::optional<Score>& score) {
    if (!score || score->decidable == 0) return "–";
    const std::string lost = std::isnan(score->digits_lost) ? "–" : fmt::format("{:.0f}", score->digits_lost);
    return fmt::format("{} / {}", score->wrong, lost);
}

} // namespace

std::vector<std::string> scores_sentences(const std::vector<FamilyScores>& families) {
    std::vector<std::string> result{"Each cell: cases with a wrong number of hits, and the digits that the "
                                    "worst of the others loses beyond what "
                                    "rounding its inputs explains. Only cases that have one right answer "
                                    "count; the first column of cases is for "
                                    "float, whose inputs are binary32, the second for the other types."};
    for (std::size_t k = 0; k < columns.size(); k += 2) {
        const Sum textbook = sum(families, columns[k]), stable = sum(families, columns[k + 1]);
        const auto far = [](const Sum& s) {
            return fmt::format("{} of {} wrong and {} beyond tolerance", s.wrong, s.decidable, s.off);
        };
        result.push_back(fmt::format("{}: textbook {}, stable {}.",
                                     scalar_name(all_numbers[columns[k]].scalar), far(textbook),
                                     far(stable)));
    }
    return result;
}

std::string scores_table(const std::vector<FamilyScores>& families) {
    std::string text = fmt::format("{:<32}", "");
    for (std::size_t k = 0; k < columns.size(); k += 2)
        text += fmt::format("{:>20}", scalar_name(all_numbers[columns[k]].scalar));
    text += "\n" + row_text({"family", "cases", "", "textbook", "stable", "textbook", "stable", "textbook",
                             "stable", "textbook", "stable"});
    for (const FamilyScores& row : families) text += row_text(cells(row));
    text += row_text(sums(families)) + "\n";
    for (const std::string& sentence : scores_sentences(families)) text += sentence + "\n";
    return text;
}

std::string scores_markdown(const std::vector<FamilyScores>& families) {
    std::string text;
    for (const std::string& sentence : scores_sentences(families)) text += sentence + "\n\n";
    text += "| family | float cases | cases |";
    for (const std::size_t k : columns)
        text +=
            fmt::format(" {} {} |", scalar_name(all_numbers[k].scalar), method_name(all_numbers[k].method));
    text += "\n| --- | --: | --: |";
    for (std::size_t k = 0; k < columns.size(); ++k) text += " --: |";
    text += "\n";
    const auto add = [&](const Cells& row) {
        text += "|";
        for (const std::string& c : row) text += " " + c + " |";
        text += "\n";
    };
    for (const FamilyScores& row : families) add(cells(row));
    add(sums(families));
    return text;
}

std::string scores_digest(const std::vector<FamilyScores>& families) {
    std::string text = "| family | cases: float, others |";
    for (const std::size_t k : columns)
        text +=
            fmt::format(" {} {} |", scalar_name(all_numbers[k].scalar), method_name(all_numbers[k].method));
    text += "\n| --- | --: |";
    for (std::size_t k = 0; k < columns.size(); ++k) text += " --: |";
    text += "\n";
    std::size_t left_out = 0;
    for (const FamilyScores& row : families) {
        if (!tells_something(row)) {
            ++left_out;
            continue;
        }
        text += fmt::format("| {} | {}, {} |", row.family, decidable(row, ScalarType::float32),
                            decidable(row, ScalarType::float64));
        for (const std::size_t k : columns) text += " " + short_cell(row.scores[k]) + " |";
        text += "\n";
    }
    text += fmt::format("| **all {} families** | {}, {} |", families.size(), sum(families, 0).decidable,
                        sum(families, 2).decidable);
    for (const std::size_t k : columns) text += " **" + short_cell(total(sum(families, k))) + "** |";
    text += fmt::format(
        "\n\nThe other {} families have no wrong count and lose less than a digit in any column.\n",
        left_out);
    return text;
}

std::string scores_json(const std::vector<FamilyScores>& families) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const FamilyScores& row : families)
        for (std::size_t k = 0; k < all_numbers.size(); ++k) {
            if (!row.scores[k]) continue;
            const Score& s = *row.scores[k];
            nlohmann::ordered_json lost;
            if (std::isfinite(s.digits_lost)) lost = s.digits_lost;
            rows.push_back({{"family", row.family},
                            {"kind", row.kind},
                            {"scalar", scalar_name(all_numbers[k].scalar)},
                            {"method", method_name(all_numbers[k].method)},
                            {"decidable", s.decidable},
                            {"wrong", s.wrong},
                            {"off", s.off},
                            {"digits_lost", lost}});
        }
    return nlohmann::ordered_json{{"format", "rayscope-cases"}, {"version", 1}, {"scores", rows}}.dump(1) +
           "\n";
}

} // namespace rayscope
