#pragma once
// What a measurement says, in words.

#include "core/accuracy/measure.hpp"

namespace rayscope {

/// "double stable costs 1.3 times float textbook and removes all 1 214 wrong pixels." and the like: the stable formulas
/// against the textbook's, the scene's depth against the next smaller one, and the cheapest of the best.
[[nodiscard]] std::vector<std::string> verdict(const std::vector<Measured>& list, const Reference& reference);

/// The cheapest whose ranked error is at most this; nothing if none is.
[[nodiscard]] const Measured* cheapest_within(const std::vector<Measured>& list, const Reference& reference,
                                              double target);

} // namespace rayscope
