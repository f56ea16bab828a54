// rayscope: the terminal program.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/view_command.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <new>

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

int guarded(int count, const char* const* arguments) {
    try {
        return std::visit([](const auto& options) { return run(options); },
                          cli::parse_options(count, arguments));
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", cli::harmless(error.what()).c_str());
        return cli::wrong_usage;
    } catch (const cli::ScriptError& error) {
        std::fprintf(stderr, "%s\n", cli::harmless_lines(error.what()).c_str());
        return cli::wrong_usage;
    } catch (const cli::UsageError& error) {
        std::fprintf(stderr, "rayscope: %s\n", cli::harmless_lines(error.what()).c_str());
        return cli::wrong_usage;
    } catch (const std::bad_alloc&) {
        std::fputs("rayscope: not enough memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rayscope: %s\n", cli::harmless(error.what()).c_str());
    }
    return cli::failed;
}

} // namespace

int main(int count, char** arguments) {
    std::signal(SIGXFSZ, SIG_IGN); // a file that grows too large is a failed write, told like any other
    if (count > 1 && std::strcmp(arguments[1], "view") == 0) return cli::view(count, arguments);
    const int code = guarded(count, arguments);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    std::fprintf(stderr, "rayscope: can't write to standard output: %s\n", std::strerror(errno));
    return code == cli::done ? cli::failed : code;
}
