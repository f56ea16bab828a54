#pragma once
// Which objects a picture or a file shows, and how finely.

#include "visualizer/drawing/clip_compound.hpp"

namespace rayscope::drawing {

struct Surface {
    std::size_t drawn = 0; ///< index into scene.drawn
    std::string name;
    bool hit = false;   ///< by a ray of the trace
    bool room = false;  ///< it has the region inside: what stands before the camera must go
    bool flat = false;  ///< a half space
    bool large = false; ///< much larger than the region: ground, rather than a thing in the picture
    Pieces pieces;
};

struct Surfaces {
    std::vector<Surface> shown;
    std::size_t left_out = 0; ///< objects near the rays for which there was no room
};

/// What rays hit, and what lies near; where that is too much for a picture, what lies nearest to the rays' ways.
[[nodiscard]] Surfaces surfaces_near(const Workbench& bench, const Trace& trace, const std::vector<Id>& drawn,
                                     const Region& region);

} // namespace rayscope::drawing
