#pragma once
// A number as text files write it.

#include <optional>
#include <string_view>

namespace rayscope {

/// The double nearest to what the whole text writes, in any locale: 0 where that is too small, an infinity where it is too
/// large; "inf" and "nan" are numbers as well. A plus sign may come first. Nothing where the text is no number.
[[nodiscard]] std::optional<double> decimal_number(std::string_view text);

/// Without a plus sign before a number, which std::from_chars does not take.
[[nodiscard]] std::string_view without_plus(std::string_view text);

} // namespace rayscope
