#pragma once
// Where a ray of the right run and of the student's part.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::exercises {

struct DivergenceText {
    std::string text;
    bool parted = false;
};
/// Both runs, ray by ray, up to their first divergence, and that.
[[nodiscard]] DivergenceText divergence_text(const Trace& right, const Trace& yours);

} // namespace rayscope::exercises
