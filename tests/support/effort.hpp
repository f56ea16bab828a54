#pragma once
// How hard the tests with random samples try: one factor for all of them.

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rayscope::test {

/// RAYSCOPE_EFFORT of the environment, else the build's; an environment value that is no positive number is ignored.
[[nodiscard]] inline double effort() {
    if (const char* text = std::getenv("RAYSCOPE_EFFORT")) {
        const double factor = std::strtod(text, nullptr);
        if (factor > 0 && std::isfinite(factor)) return factor;
    }
    return RAYSCOPE_DEFAULT_EFFORT;
}

/// `base` samples times the effort, at least one.
[[nodiscard]] inline int samples(int base) {
    return int(std::clamp(std::round(double(base) * effort()), 1.0, 1e9));
}

} // namespace rayscope::test
