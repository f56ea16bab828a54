#include "visualizer/cli/warnings.hpp"

#include "visualizer/cli/page.hpp"

#include <algorithm>
#include <cstdio>

namespace rayscope::cli {

void print_warnings(const Scene& scene) { print_warnings(scene.warnings); }

void print_warnings(const std::vector<std::string>& warnings) {
    constexpr std::size_t most = 5;
    for (std::size_t i = 0; i < std::min(warnings.size(), most); ++i)
        std::fprintf(stderr, "warning: %s\n", harmless(warnings[i]).c_str());
    if (warnings.size() > most) std::fprintf(stderr, "warning: … and %zu more\n", warnings.size() - most);
}

} // namespace rayscope::cli
