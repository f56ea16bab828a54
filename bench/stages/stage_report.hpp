#pragma once
// What was measured, for programs and for people.

#include "bench/stages/measured_scene.hpp"

#include <filesystem>

namespace rayscope::bench {

/// Time per ray against the number of objects, of one stage and one kind of ray, in clouds.
struct Growth {
    std::string stage;
    Rays rays;
    std::vector<std::pair<double, double>> points; ///< objects, nanoseconds
    double exponent = 0; ///< of the power of N that fits them best, all weighed alike
};
[[nodiscard]] std::vector<Growth> growth_of(const std::vector<StageRun>& runs);

/// One line for each run.
[[nodiscard]] std::string csv_of(const std::vector<StageRun>& runs);
/// A page of Markdown: what each stage bought, and where it lost.
[[nodiscard]] std::string page_of(const std::vector<StageRun>& runs, const std::vector<Growth>& growth,
                                  const std::string& peers);
/// For the chart, as rayscope-view reads it.
[[nodiscard]] std::string json_of(const std::vector<Growth>& growth);

} // namespace rayscope::bench
