#pragma once
// What the oracle's hard cases say of a shape.

#include "core/cases/score.hpp"

#include <array>
#include <string>

namespace rayscope::bench {

/// In each of all_numbers, over all families whose names begin so (float: those about binary32); no decidable case where
/// there is none.
[[nodiscard]] inline std::array<Score, all_numbers.size()> hard_cases(const std::string& families) {
    std::array<Score, all_numbers.size()> sums;
    for (const CaseFile& file : case_files(RAYSCOPE_CASES)) {
        if (!file.family.starts_with(families)) continue;
        const bool is_narrow = file.epsilon == double(epsilon<float>);
        for (std::size_t k = 0; k < all_numbers.size(); ++k) {
            if ((all_numbers[k].scalar == ScalarType::float32) != is_narrow) continue;
            const auto found = score(file, all_numbers[k]);
            if (!found) continue;
            sums[k].decidable += found->decidable;
            sums[k].wrong += found->wrong;
            if (found->digits_lost >= 0 && !(sums[k].digits_lost >= found->digits_lost))
                sums[k].digits_lost = found->digits_lost;
        }
    }
    return sums;
}

} // namespace rayscope::bench
