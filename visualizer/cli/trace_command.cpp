// rayscope trace: one ray into a file.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/trace_file.hpp"
#include "visualizer/cli/warnings.hpp"

#include <cstdio>

namespace rayscope::cli {

int trace(const TraceOptions& options) {
    check_trace_file("-o", options.output);
    const Workbench bench =
        make_workbench(load_with_effects(find_scene(options.choice.scene), options.choice.effects));
    print_warnings(bench.scene);
    write_trace_file(bench, trace_choice(bench, options.choice), options.output);
    std::puts(harmless(options.output).c_str());
    return done;
}

} // namespace rayscope::cli
