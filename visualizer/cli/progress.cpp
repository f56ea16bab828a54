#include "visualizer/cli/progress.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include <unistd.h>

namespace rayscope::cli {

Progress::Progress(std::string what) : what_(std::move(what)), terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void Progress::show(double share) {
    const int percent = std::clamp(int(100 * share), 0, 100);
    if (!terminal_ || percent == percent_) return;
    percent_ = percent;
    constexpr int width = 40;
    const int filled = width * percent / 100;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    const std::string rest =
        share > 0 ? fmt::format("{:.0f} s left", spent.count() * (1 - share) / share) : std::string();
    const std::string line = fmt::format("\r{} {:█<{}}{:░<{}} {:3} %  {}\033[K", what_, "", filled, "",
                                         width - filled, percent, rest);
    std::fputs(line.c_str(), stderr);
}

} // namespace rayscope::cli
