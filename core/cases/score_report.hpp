#pragma once
// Scores as a table for terminals, as Markdown, and as JSON (format rayscope-cases, version 1).

#include "core/cases/score.hpp"

namespace rayscope {

[[nodiscard]] std::string scores_table(const std::vector<FamilyScores>& families);
[[nodiscard]] std::string scores_markdown(const std::vector<FamilyScores>& families);
[[nodiscard]] std::string scores_json(const std::vector<FamilyScores>& families);

/// A short table in Markdown for a page: only families that somebody gets wrong or loses a digit on, in whole digits, so
/// that every build and machine writes the same.
[[nodiscard]] std::string scores_digest(const std::vector<FamilyScores>& families);

/// What one row's numbers mean, and the whole in a sentence for each scalar type.
[[nodiscard]] std::vector<std::string> scores_sentences(const std::vector<FamilyScores>& families);

} // namespace rayscope
