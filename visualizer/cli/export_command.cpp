// rayscope export: a scene for another program.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/warnings.hpp"

#include <cstdio>

namespace rayscope::cli {

int export_scene(const ExportOptions& options) {
    check_output("-o", options.output, {".pov"});
    const Workbench bench = open(find_scene(options.scene));
    PovrayFile file = to_povray(bench.scene, bench.world);
    print_warnings(bench.scene);
    for (std::string& difference : file.differences) difference.insert(0, "in POV-Ray: ");
    print_warnings(file.differences);
    write_text_file(options.output, file.text);
    std::puts(harmless(options.output).c_str());
    return done;
}

} // namespace rayscope::cli
