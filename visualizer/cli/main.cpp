// rayscope: the terminal program.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/large_pages.hpp"
#include "visualizer/cli/view_command.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace {

using namespace rayscope;

int run(const cli::Help& help) {
    std::fputs(help.text.c_str(), stdout);
    return cli::done;
}
int run(const cli::StepOptions& options) { return cli::step(options); }
int run(const cli::TraceOptions& options) { return cli::trace(options); }
int run(const cli::FindCommandOptions& options) { return cli::find(options); }
int run(const cli::DiffOptions& options) { return cli::diff(options); }
int run(const cli::RenderCommandOptions& options) { return cli::render(options); }
int run(const cli::ExplainOptions& options) { return cli::explain(options); }
int run(const cli::ExtentsOptions& options) { return cli::extents(options); }
int run(const cli::ExportOptions& options) { return cli::export_scene(options); }
int run(const cli::AccuracyCommandOptions& options) { return cli::accuracy(options); }
int run(const cli::CasesOptions& options) { return cli::cases(options); }

} // namespace

int main(int count, char** arguments) {
    cli::use_large_pages();
    std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is a failed write, told like any other
    if (count > 1 && std::strcmp(arguments[1], "view") == 0) return cli::view(count, arguments);
    const int code = cli::guarded([&] {
        return std::visit([](const auto& options) { return run(options); },
                          cli::parse_options(count, arguments));
    });
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    std::fprintf(stderr, "rayscope: can't write to standard output: %s\n", std::strerror(errno));
    return code == cli::done ? cli::failed : code;
}
