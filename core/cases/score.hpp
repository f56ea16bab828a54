#pragma once
// How well numbers stand the oracle's cases: what they get wrong, and how many digits they lose.

#include "core/cases/case_files.hpp"
#include "core/math/numbers.hpp"

#include <array>
#include <atomic>
#include <functional>
#include <limits>
#include <optional>

namespace rayscope {

/// Of one family in one choice of numbers.
struct Score {
    int decidable = 0; ///< cases that have one right answer, whatever inputs off by 64 ε
    int wrong =
        0; ///< of those: a hit or a miss too many, a NaN, disorder; total reflection where there is none …
    int off = 0; ///< of those: all there, but a value beyond its tolerance for inputs off by 4 ε
    /// log₁₀ of the worst error over ε · condition, the error that rounding the inputs explains; at least 0. NaN where
    /// nothing could be measured.
    double digits_lost = std::numeric_limits<double>::quiet_NaN();

    void add_error(double in_units); ///< of ε · condition
};

/// Scores of one family, one for each of all_numbers.
struct FamilyScores {
    std::string family;
    std::string kind;
    std::array<std::optional<Score>, all_numbers.size()>
        scores; ///< none where the family is not for these numbers
};

struct ScoreOptions {
    std::function<void(double)> progress; ///< 0 … 1
    const std::atomic<bool>* stop = nullptr;
};

/// The score of one file's cases. Tolerances are brought to the ε of the numbers. What a file states in doubles (bent
/// directions, mirrored paths) is measured against __float128 in the stable formulas, where the numbers are wider.
/// Throws InputError where the file can't be read. None for a kind without a subject here.
[[nodiscard]] std::optional<Score> score(const CaseFile& file, NumbersChoice numbers);

/// All families of a folder. float is put to those about binary32, which are called FAMILY_f32 and share a row with
/// FAMILY; the others to those about double. Empty where it was stopped.
[[nodiscard]] std::vector<FamilyScores> score_folder(const std::filesystem::path& folder,
                                                     const ScoreOptions& options = {});

} // namespace rayscope
