#pragma once
// The operands of a compound, each as the whole solid that it is: also what a difference took away.

#include "visualizer/drawing/surfaces.hpp"

namespace rayscope::window {

/// One surface for each generic of a compound, to be shown as a ghost; none for a plain generic.
[[nodiscard]] std::vector<drawing::Surface> operands_of(const Scene& scene, std::size_t drawn,
                                                        const drawing::Region& region);

} // namespace rayscope::window
