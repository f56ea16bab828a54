#include "visualizer/cli/interrupts.hpp"

#include <csignal>

namespace rayscope::cli {

std::atomic<bool> stop_asked_for{false};
static_assert(std::atomic<bool>::is_always_lock_free); // a signal handler may set nothing else

void catch_interrupts() {
    struct sigaction action{};
    action.sa_handler = [](int) { stop_asked_for = true; };
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    sigaction(SIGINT, &action, nullptr);
}

} // namespace rayscope::cli
