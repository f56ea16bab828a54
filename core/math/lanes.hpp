#pragma once
// Comparisons of many numbers at once.

#include <cstddef>

namespace rayscope {

/// Bit i: lane i of the mask is set.
template <typename Mask> [[nodiscard, gnu::always_inline]] inline unsigned bits_of(const Mask& mask) {
    // libstdc++'s own: two instructions, where a loop takes twenty.
    if constexpr (requires { mask.__to_bitset(); }) return unsigned(mask.__to_bitset().to_ulong());
    unsigned bits = 0;
    for (std::size_t i = 0; i < Mask::size(); ++i) bits |= unsigned(mask[i]) << i;
    return bits;
}

} // namespace rayscope
