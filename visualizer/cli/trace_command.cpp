// rayscope trace: one ray into a file.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/warnings.hpp"
#include "visualizer/page/page.hpp"

#include <cstdio>

namespace rayscope::cli {

int trace(const TraceOptions& options) {
    const std::filesystem::path output = options.output;
    check_output("-o", options.output, {".json", ".html", ".vtm"});
    const bool for_paraview = output.extension() == ".vtm";
    if (for_paraview && !can_draw()) throw std::runtime_error(how_to_draw());
    const Workbench bench =
        make_workbench(load_with_effects(find_scene(options.choice.scene), options.choice.effects));
    print_warnings(bench.scene);
    const Trace traced = trace_choice(bench, options.choice);
    if (for_paraview)
        draw(Drawing::vtm, traced, output);
    else if (output.extension() == ".html")
        page::write_page(bench, traced, output);
    else
        write_trace(traced, output);
    std::puts(harmless(options.output).c_str());
    return done;
}

} // namespace rayscope::cli
