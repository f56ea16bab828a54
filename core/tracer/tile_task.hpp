#pragma once
// What TBB copies from thread to thread. In a file of its own, by whose name .ci/thread-suppressions tells a checker's
// false alarms about those copies from races in the renderer.

#include <tbb/blocked_range2d.h>

namespace rayscope {

/// A task that renders the tiles that it is given.
template <typename Renderer> [[nodiscard]] auto tile_task(Renderer& renderer) {
    return [&renderer](const tbb::blocked_range2d<int>& pixels) { renderer.render_tile(pixels); };
}

} // namespace rayscope
