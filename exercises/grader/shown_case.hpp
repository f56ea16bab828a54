#pragma once
// The recorded ray that shows a case: that of the right answer, and that of a wrong one where it can be drawn.

#include "core/rayscope.hpp"
#include "exercises/grader/reference.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace rayscope::exercises {

struct ShownCase {
    std::string scene;       ///< a scene file's text
    std::string yours;       ///< the scene that the wrong answer makes; empty if there is none
    Ray<double> ray;         ///< in both
    std::string note, stage; ///< as in the harness's Shown
};
/// Nothing if the exercise shows no ray.
[[nodiscard]] std::optional<ShownCase> shown(const Toolchain& toolchain, const Reference& reference,
                                             std::size_t index, const Outcome& answer);

/// The ray as --ray takes it.
[[nodiscard]] std::string text_of(const Ray<double>& ray);

/// Both runs of the ray.
struct ShownRuns {
    ShownCase shown;
    Trace right;
    std::optional<Trace> yours; ///< by the scene of the answer, or by the function in the tracer's place
    bool parted = false;        ///< whether they have a first divergence
};
/// Nothing if the exercise shows no ray, or its scene can't be drawn.
/// @param program the student's, which may stand for a formula of the tracer
[[nodiscard]] std::optional<ShownRuns> shown_runs(const Toolchain& toolchain, const Reference& reference,
                                                  std::size_t index, const Outcome& answer,
                                                  const std::filesystem::path& program);

} // namespace rayscope::exercises
