#pragma once
// What the messages about wrong input have in common.

#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// 'text' in quotes, fit for one line of a terminal: control characters and broken UTF-8 become '?', and what is
/// longer than 60 characters is cut with "…".
[[nodiscard]] std::string in_quotes(std::string_view text);

/// "; did you mean 'glass'?" for the candidate nearest to `name`, or "" if none is near. Near: at most a third of
/// the letters are inserted, deleted, replaced or swapped with a neighbour. Looks at the first 10 000 candidates.
[[nodiscard]] std::string did_you_mean(std::string_view name,
                                       const std::vector<std::string_view>& candidates);

/// "a, b or c".
[[nodiscard]] std::string one_of(const std::vector<std::string_view>& choices);

} // namespace rayscope
