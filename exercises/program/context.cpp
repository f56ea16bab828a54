#include "exercises/program/context.hpp"

#include "exercises/program/failure.hpp"

#include <cstdio>

namespace rayscope::exercises {
namespace fs = std::filesystem;

Context make_context(const Options& options) {
    return {options, read_catalogue(options.catalogue.value_or(RAYSCOPE_EXERCISES))};
}

std::unique_ptr<Toolchain> make_toolchain(const Context& context) {
    Safety safety = Safety::sandboxed;
    if (context.options.unsafe) {
        safety = Safety::unsafe;
        std::fputs("rayscope: WITHOUT A SANDBOX: the code that is checked can read and send what you can.\n",
                   stderr);
    } else if (const std::string why = why_no_sandbox(); !why.empty()) {
        throw UsageError("no sandbox, so no foreign code is run: " + why +
                         "\n--unsafe runs it all the same, with your rights: only for code that you trust");
    }
    std::error_code ignored;
    const fs::path runner =
        fs::read_symlink("/proc/self/exe", ignored).parent_path() / "rayscope-exercise-runner";
    return std::make_unique<Toolchain>(fs::path(RAYSCOPE_EXERCISES) / "harness", runner, safety);
}

} // namespace rayscope::exercises
