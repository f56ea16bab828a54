#pragma once
// The verdict on one student's file.

#include "exercises/grader/reference.hpp"

namespace rayscope::exercises {

struct CaseResult {
    bool right = false;
    Outcome outcome;
    std::string complaint; ///< of a judged exercise
};

struct GroupResult {
    int right = 0, cases = 0;
    double score = 0; ///< points · right / cases, in hundredths of a point
};

struct Grade {
    bool compiled = false;
    std::vector<Diagnostic> diagnostics;      ///< of the student's own lines
    std::string problem;                      ///< why it did not compile, where no line says it
    std::vector<CaseResult> cases;            ///< as in the reference; empty if it did not compile
    std::vector<GroupResult> groups;          ///< as in the exercise
    std::optional<std::size_t> misconception; ///< index into Exercise::misconceptions
    double score = 0;

    [[nodiscard]] bool all_right() const;
};

/// Runs a student's compiled code. The verdicts are made here, from the bytes that come back.
/// @param words of the program; a student's needs none
[[nodiscard]] Grade grade(const Toolchain& toolchain, const Reference& reference, const Compiled& answers,
                          CaseRunner::Trust trust = CaseRunner::Trust::none,
                          const std::vector<std::string>& words = {});
/// Compiles it first.
[[nodiscard]] Grade grade(const Toolchain& toolchain, const Reference& reference, const std::string& code);

} // namespace rayscope::exercises
