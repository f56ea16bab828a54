#pragma once
// Random numbers that a failing test can name: one seed makes the whole sequence, the same on every machine.

#include "core/math/ray.hpp"

#include <cstdint>

namespace rayscope::test {

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    /// SplitMix64 (Steele, Lea, Flood 2014).
    std::uint64_t bits() {
        std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
        return z ^ (z >> 31);
    }
    double uniform(double low, double high) { return low + (high - low) * double(bits() >> 11) * 0x1p-53; }
    int below(int count) { return int(bits() % std::uint64_t(count)); }
    bool coin() { return (bits() & 1) != 0; }
    /// 10^x for x uniform in [low, high].
    double decade(double low, double high) { return std::pow(10.0, uniform(low, high)); }

    Vec3d in_cube(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    /// Uniform on the unit sphere.
    Vec3d direction() {
        for (;;) {
            const Vec3d v = in_cube(1);
            const double l = length(v);
            if (l > 0.1 && l <= 1) return v / l;
        }
    }
    /// From a point within `distance` roughly towards [−1, 1]³.
    Ray<double> towards_unit_cube(double distance) {
        const Vec3d origin = in_cube(distance);
        return {origin, in_cube(1.3) - origin};
    }

private:
    std::uint64_t state_;
};

} // namespace rayscope::test
