#pragma once
// Where a ray of the student's run and of ours part.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::exercises {

struct DivergenceText {
    std::string text;
    bool parted = false;
};
/// Both runs, ray by ray, up to their first divergence, and that.
[[nodiscard]] DivergenceText divergence_text(const Trace& ours, const Trace& theirs);

} // namespace rayscope::exercises
