// rayscope diff: where two runs of one ray part.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/second_run.hpp"
#include "visualizer/cli/warnings.hpp"

#include <cstdio>

#include <unistd.h>

namespace rayscope::cli {

int diff(const DiffOptions& options) {
    const Workbench bench = open(find_scene(options.choice.scene));
    print_warnings(bench.scene);
    const Trace trace = trace_choice(bench, options.choice);
    const StepStyle style{Numbers(options.digits), Paint(wants_colours(STDOUT_FILENO))};
    const SecondRun second = options.other   ? run_of_scene(*options.other, trace)
                             : options.stage ? run_by_stage("--stage", *options.stage, bench, trace)
                                             : second_run("--config", *options.configuration, bench, trace);
    std::fputs(second_run_text(second, bench, trace, style).c_str(), stdout);
    return done;
}

} // namespace rayscope::cli
