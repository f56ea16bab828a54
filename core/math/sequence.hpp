#pragma once
// Sample points that are spread evenly, and the same on every machine.

#include <cstdint>

namespace rayscope {

/// A well-mixed number for each pair: the finalizer of MurmurHash3 over their combination.
[[nodiscard]] constexpr std::uint32_t mixed(std::uint32_t seed, std::uint32_t value) {
    std::uint32_t h = seed ^ (value + 0x9e3779b9U + (seed << 6U) + (seed >> 2U));
    h = (h ^ (h >> 16U)) * 0x85ebca6bU;
    h = (h ^ (h >> 13U)) * 0xc2b2ae35U;
    return h ^ (h >> 16U);
}

/// A point of the unit square, 0 ≤ x, y < 1.
struct SquarePoint {
    double x, y;
};

/// Sobol's (0, 2)-sequence: each 2^m points from a multiple of 2^m on fall one into each of the 2^m boxes of every
/// grid of 2^a × 2^(m−a). To flip the same binary digits of all points keeps that (Kollig and Keller, 2002).
[[nodiscard]] constexpr SquarePoint sobol(std::uint32_t index, std::uint32_t flipped_x,
                                          std::uint32_t flipped_y) {
    std::uint32_t x = flipped_x, y = flipped_y;
    for (std::uint32_t bit = 1U << 31U, direction = 1U << 31U; index != 0;
         index >>= 1U, bit >>= 1U, direction ^= direction >> 1U) {
        if ((index & 1U) == 0) continue;
        x ^= bit;
        y ^= direction;
    }
    return {double(x) * 0x1p-32, double(y) * 0x1p-32};
}

/// The same, flipped by a hash, so that neighbours differ.
[[nodiscard]] constexpr SquarePoint hashed_sobol(std::uint32_t index, std::uint32_t seed) {
    return sobol(index, mixed(seed, 1), mixed(seed, 2));
}

/// Which sample of an image, and which ray of it: what is random about a ray is hashed from this.
struct SampleAddress {
    int x = 0, y = 0, sample = 0;

    [[nodiscard]] constexpr std::uint32_t seed() const {
        return mixed(mixed(mixed(0, std::uint32_t(x)), std::uint32_t(y)), std::uint32_t(sample));
    }
};

} // namespace rayscope
