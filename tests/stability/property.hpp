#pragma once
// Properties by RapidCheck: the corpus first, then cases by chance, the same ones in every run unless RC_PARAMS says
// otherwise. A failure names the seed and prints its case.

#include "tests/stability/cases.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <sstream>

namespace rayscope::test {

/// Draws from RapidCheck, successes times; what it found wrong, shrunk, is the test's failure.
template <typename Testable> void expect_property(const char* name, int successes, const Testable& testable) {
    rc::detail::TestMetadata metadata;
    metadata.id = metadata.description = name;
    rc::detail::TestParams params = rc::detail::configuration().testParams;
    if (std::getenv("RC_PARAMS") == nullptr) params.seed = 1;
    params.maxSuccess = successes;
    const auto result = rc::detail::checkTestable(testable, metadata, params);
    if (result.template is<rc::detail::SuccessResult>()) return;
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    ADD_FAILURE() << name << ": RC_PARAMS=seed=" << params.seed << '\n' << text.str();
}

/// A draw costs more than a cheap case does: RapidCheck draws the seeds, each of so many cases.
inline constexpr int cases_of_a_seed = 500;

/// @param draw makes a case out of a Random
/// @param judge its Verdict
/// @param least the share of the cases that must be decided; the others are within rounding of both answers
template <typename Draw, typename Judge>
void expect_of_cases(const char* name, int cases, double least, const Draw& draw, const Judge& judge) {
    for (const Case& c : corpus())
        if (const Verdict verdict = judge(c); !verdict.wrong.empty())
            ADD_FAILURE() << name << ": " << verdict.wrong << "\nof the corpus: " << line_of(c);
    int asked = 0, decided = 0;
    expect_property(name, std::max(1, cases / cases_of_a_seed), [&] {
        const auto seed =
            *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
        Random random(seed);
        for (int i = 0; i < cases_of_a_seed; ++i) {
            const Case c = draw(random);
            const Verdict verdict = judge(c);
            ++asked;
            decided += verdict.decided ? 1 : 0;
            if (!verdict.wrong.empty()) RC_FAIL(verdict.wrong + '\n' + line_of(c));
        }
    });
    // Few cases, much chance: four standard deviations of a number of successes.
    EXPECT_GE(decided, least * asked - 4 * std::sqrt(least * asked)) << name << " of " << asked;
}

} // namespace rayscope::test
