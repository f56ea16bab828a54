#include "visualizer/cli/failure.hpp"

#include "core/rayscope.hpp"
#include "visualizer/cli/page.hpp"

#include <cstdio>
#include <new>

namespace rayscope::cli {

int stopped() {
    std::fputs("rayscope: stopped; nothing was written\n", stderr);
    return interrupted;
}

int guarded(const std::function<int()>& work) {
    try {
        return work();
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", harmless(error.what()).c_str());
        return wrong_usage;
    } catch (const ScriptError& error) {
        std::fprintf(stderr, "%s\n", harmless_lines(error.what()).c_str());
        return wrong_usage;
    } catch (const UsageError& error) {
        std::fprintf(stderr, "rayscope: %s\n", harmless_lines(error.what()).c_str());
        return wrong_usage;
    } catch (const std::bad_alloc&) {
        std::fputs("rayscope: not enough memory\n", stderr);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rayscope: %s\n", harmless(error.what()).c_str());
    }
    return failed;
}

} // namespace rayscope::cli
