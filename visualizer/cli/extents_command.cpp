// rayscope extents: the screen as the stage of projective extents sees it.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/cli/scene_choice.hpp"

#include <cstdio>

namespace rayscope::cli {

int extents(const ExtentsOptions& options) {
    check_output("-o", options.output, {".png"});
    if (!can_draw()) throw std::runtime_error(how_to_draw());
    draw_extents(find_scene(options.scene), options.output, options.size);
    std::puts(harmless(options.output).c_str());
    return done;
}

} // namespace rayscope::cli
