#include "tests/window/screen.hpp"

#include <gtest/gtest.h>

#include <csignal>
#include <sstream>

#include <fcntl.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rayscope::test {

Screen::Screen() {
    int ends[2];
    if (pipe(ends) != 0) return;
    process_ = fork();
    if (process_ == 0) {
        const int nothing = ::open("/dev/null", O_RDWR);
        dup2(nothing, STDOUT_FILENO);
        dup2(nothing, STDERR_FILENO);
        const std::string descriptor = std::to_string(ends[1]);
        close(ends[0]);
        execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1600x1000x24", "-nolisten",
               "tcp", "-noreset", nullptr);
        _exit(127);
    }
    close(ends[1]);
    std::string text; // its number, and the end of the line
    pollfd waiting{ends[0], POLLIN, 0};
    constexpr int patience = 30'000; // milliseconds
    for (char c = 0; poll(&waiting, 1, patience) > 0 && read(ends[0], &c, 1) == 1 && c != '\n';) text += c;
    close(ends[0]);
    if (!text.empty()) number_ = std::stoi(text);
}

Screen::~Screen() {
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
}

std::vector<std::string> Screen::environment() const {
    return {"DISPLAY=:" + std::to_string(number_), "QT_QPA_PLATFORM=xcb", "LIBGL_ALWAYS_SOFTWARE=1",
            "QT_SCALE_FACTOR=1"};
}

Reports run_window(const Screen& screen, const std::string& scene, const std::string& script,
                   const std::vector<std::string>& more) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "script";
    std::ofstream(file) << script;
    std::vector<std::string> arguments{"view", scene, "--script", file.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    Reports reports{run_program(arguments, {RAYSCOPE_SOURCE_DIR, screen.environment(), {}}), {}};
    std::istringstream out(reports.outcome.out);
    for (std::string line; std::getline(out, line);) {
        auto report = nlohmann::json::parse(line, nullptr, false);
        if (report.is_discarded()) {
            ADD_FAILURE() << "no JSON: " << line;
            continue;
        }
        reports.lines.push_back(std::move(report));
    }
    EXPECT_FALSE(reports.lines.empty()) << reports.outcome.err;
    if (reports.lines.empty()) reports.lines.emplace_back();
    return reports;
}

} // namespace rayscope::test
