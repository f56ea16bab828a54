#pragma once
// Scores as a table for terminals, as Markdown, and as JSON (format rayscope-cases, version 1).

#include "core/cases/score.hpp"

namespace rayscope {

[[nodiscard]] std::string scores_table(const std::vector<FamilyScores>& families);
[[nodiscard]] std::string scores_markdown(const std::vector<FamilyScores>& families);
[[nodiscard]] std::string scores_json(const std::vector<FamilyScores>& families);

/// What one row's numbers mean, and the whole in a sentence for each scalar type.
[[nodiscard]] std::vector<std::string> scores_sentences(const std::vector<FamilyScores>& families);

} // namespace rayscope
