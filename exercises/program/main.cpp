// rayscope-exercises: what students and instructors do with the exercises.

#include "core/scene/input_error.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>

namespace {

using namespace rayscope;
using namespace rayscope::exercises;

int guarded(int count, const char* const* arguments) {
    try {
        const Options options = parse_options(count, arguments);
        if (const auto* help = std::get_if<Help>(&options.command)) {
            std::fputs(help->text.c_str(), stdout);
            return done;
        }
        return run_command(make_context(options));
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return wrong_usage;
    } catch (const UsageError& error) {
        std::fprintf(stderr, "rayscope: %s\n", error.what());
        return wrong_usage;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rayscope: %s\n", error.what());
        return failed;
    }
}

} // namespace

int main(int count, char** arguments) {
    std::signal(SIGPIPE, SIG_IGN); // a child that ended is told by write()
    const int code = guarded(count, arguments);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return code;
    std::fprintf(stderr, "rayscope: can't write to standard output: %s\n", std::strerror(errno));
    return code == done ? failed : code;
}
